#!/usr/bin/env python3
"""Four traces, one hash a line: the engine built by several compilers and levels, run on every kind of
vectors that the machine has and with FMA hidden from libm, against tests/golden/engine_trace.txt (the
whole tick), tools_trace.txt (every tool, every effect), hard_trace.txt (random hands in random scenes) and
handle_trace.txt (what a force device is given).

  tests/determinism/matrix.py [--all | --arm64] [--build build/determinism] [--seconds 6]
  --all: both compilers at all levels, not only the telling ones
  --arm64: cross-compiled and emulated (tests/arm64/run installs what that needs)
  exit 0: all the same, 1: not, or not all could be built
"""

import argparse
import concurrent.futures
import os
import platform
import shutil
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
GOLDEN = os.path.join(ROOT, "tests/golden")
COMPILERS = ["g++", "clang++"]
# The last lets the compiler use whatever this processor has, FMA too.
LEVELS = ["-O0", "-O2", "-O3", "-O3 -march=native"]
# What tells most for its time: the other compiler, and FMA. g++ -O3 is the Release that engine/scene's tests hold to the goldens.
TELLING = [("g++", "-O3 -march=native"), ("clang++", "-O3")]
# For ARM, where FMA is always there: nothing optimised, as museums run it, and for the processor of a Raspberry Pi 5.
ARM64 = [("aarch64-linux-gnu-g++", "-O0"), ("aarch64-linux-gnu-g++", "-O3"),
         ("aarch64-linux-gnu-g++", "-O3 -mcpu=cortex-a76"), ("clang++", "-O3 --target=aarch64-linux-gnu")]
ARM64_TOOLCHAIN = os.path.join(ROOT, "tests/arm64/toolchain.cmake")
EMULATOR = "qemu-aarch64"
# Kinds of vectors that each build must have where the processor does, and the processor's flag.
WANTED = [("plain", None), ("sse2", "sse2"), ("avx2", "avx2")]
HIDE_FMA = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4"}


def folder(compiler, level):
    """Name of the one that such a build has."""
    return f"{compiler}{level}".replace("+", "x").replace(" ", "").replace("=", "-")


def build(compiler, level, where, *more):
    """Path of the program; empty, with what was said, where it cannot be built. `more`: options of cmake's."""
    quiet = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "cwd": ROOT}
    for words in (["cmake", "-S", ROOT, "-B", where, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                   "-DCMAKE_BUILD_TYPE=", f"-DCMAKE_CXX_FLAGS={level}", "-DONGGI_KIOSK=OFF", "-DONGGI_UNITY=ON", *more],
                  ["cmake", "--build", where, "--target", "engine_trace"]):
        run = subprocess.run(words, **quiet)
        if run.returncode:
            print(run.stdout)
            return ""
    return os.path.join(where, "bin", "engine_trace")


def run(program, *words, environment=None):
    out = subprocess.run([*program, *words], env={**os.environ, **(environment or {})},
                         capture_output=True, text=True)
    if out.returncode:
        print(out.stderr)
    return out.stdout.splitlines()


def missing(kinds, arm64):
    """Names of the vectors that a build should have had."""
    if arm64:
        return {"plain", "neon"}.difference(kinds)
    if platform.machine() != "x86_64":
        return [] if kinds else ["any"]
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        flags = set(file.read().split())
    return [name for name, flag in WANTED if (flag is None or flag in flags) and name not in kinds]


def read_golden(name):
    with open(os.path.join(GOLDEN, name), encoding="utf-8") as file:
        return file.read().splitlines()


def verdict(lines, golden):
    """"same", or where the first difference is."""
    for number, (ours, wanted) in enumerate(zip(lines, golden), 1):
        if ours != wanted:
            return f"DIFFERS in line {number}: {ours}, not {wanted}"
    return "same" if len(lines) == len(golden) else f"BROKE OFF after {len(lines)} lines"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--all", action="store_true")
    which.add_argument("--arm64", action="store_true")
    parser.add_argument("--build", default=os.path.join(ROOT, "build/determinism"))
    parser.add_argument("--seconds", type=int, default=6)
    arguments = parser.parse_args()
    whole = read_golden("engine_trace.txt")[:arguments.seconds]
    others = {f"--{name}": read_golden(f"{name}_trace.txt") for name in ("tools", "hard", "handle")}
    wrong, runs, hidden = 0, 0, set()

    def report(what, result):
        nonlocal wrong, runs
        runs += 1
        wrong += result != "same"
        print(f"  {what:28} {result}", flush=True)

    def all_of(program, *words, environment=None):
        result = verdict(run(program, "--seconds", str(arguments.seconds), *words,
                             environment=environment), whole)
        if result != "same":
            return result
        for name, golden in others.items():
            result = verdict(run(program, name, *words, environment=environment), golden)
            if result != "same":
                return f"{name[2:]}: {result}"
        return "same"

    # A run has one thread. Those of a build go side by side, beside the next build too, and are told in order.
    runners = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    told = []
    combinations = TELLING
    if arguments.all:
        combinations = [(c, v) for c in COMPILERS for v in LEVELS]
    elif arguments.arm64:
        combinations = ARM64
    cross = [f"-DCMAKE_TOOLCHAIN_FILE={ARM64_TOOLCHAIN}"] if arguments.arm64 else []
    for compiler, level in combinations:
        if not shutil.which(compiler):
            print(f"{compiler} is not here: tests/packages.txt names it.")
            wrong += 1
            continue
        print(f"Compiling: {compiler} {level}", flush=True)
        program = build(compiler, level, os.path.join(arguments.build, folder(compiler, level)), *cross)
        rows = []
        told.append((f"{compiler} {level}", program, rows))
        if not program:
            continue
        program = [EMULATOR, program] if arguments.arm64 else [program]
        kinds = run(program, "--kinds")
        rows += [(kind, lambda: "MISSING from this build") for kind in missing(kinds, arguments.arm64)]
        rows += [(kind, runners.submit(all_of, program, "--vectors", kind).result) for kind in kinds]
        # Hidden only where libm's own answers change by it: else the row would test nothing.
        if run(program, "--libm") == run(program, "--libm", environment=HIDE_FMA):
            hidden.add(False)
        else:
            hidden.add(True)
            rows.append(("FMA hidden from libm",
                         runners.submit(all_of, program, environment=HIDE_FMA).result))
    for what, program, rows in told:
        print(what, flush=True)
        if not program:
            report("build", "FAILED")
        for row, result in rows:
            report(row, result())
    if False in hidden:
        print("Where libm gives the same bits with FMA hidden, there is no row for it.")

    if True not in hidden:
        print("FMA could not be hidden on this machine, so that row is open.")
    print(f"{runs - wrong} of {runs} runs gave the golden's {len(whole) + sum(map(len, others.values()))} hashes.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
