#!/usr/bin/env python3
"""One trace, one hash: the engine built by each compiler at each level, run on every kind of vector
that the machine has and with FMA hidden from libm, against tests/golden/engine_trace.txt.

  tests/determinism/matrix.py [--build build/determinism] [--seconds 6]
  exit 0: all the same, 1: not, or not all could be built
"""

import argparse
import os
import platform
import shutil
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
GOLDEN = os.path.join(ROOT, "tests/golden/engine_trace.txt")
COMPILERS = ["g++", "clang++-14"]
# The last lets the compiler use whatever this processor has, FMA too.
LEVELS = ["-O0", "-O2", "-O3", "-O3 -march=native"]
# Kinds of vectors that each build must have where the processor does: Highway's names for them, and
# the processor's flag. A build for this very processor has only the best.
WANTED = [(("SCALAR", "EMU128"), None), (("SSE4",), "sse4_2"), (("AVX2",), "avx2")]
HIDE_FMA = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4"}


def build(compiler, level, folder, target="engine_trace"):
    """Path of the program; empty, with what was said, where it cannot be built.

    The trace is a ball's. The other tools take g++ five minutes a level; that they give the same bits is
    for their own tests, which run from both compilers.
    """
    quiet = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "cwd": ROOT}
    for words in (["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                   "-DCMAKE_BUILD_TYPE=", f"-DCMAKE_CXX_FLAGS={level}", "-DONGGI_KIOSK=OFF",
                   "-DONGGI_TOOLS=sphere"],
                  ["cmake", "--build", folder, "--target", target]):
        run = subprocess.run(words, **quiet)
        if run.returncode:
            print(run.stdout)
            return ""
    return os.path.join(folder, "bin", target)


def run(program, *words, environment=None):
    out = subprocess.run([program, *words], env={**os.environ, **(environment or {})},
                         capture_output=True, text=True)
    if out.returncode:
        print(out.stderr)
    return out.stdout.split()


def missing(kinds, level):
    """Names of the vectors that a build should have had."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        flags = set(file.read().split())
    if platform.machine() != "x86_64" or "native" in level:
        return [] if kinds else ["any"]
    return [names[0] for names, flag in WANTED
            if (flag is None or flag in flags) and not set(names) & set(kinds)]


def verdict(hashes, golden):
    """"same", or where the first difference is."""
    for second, (ours, wanted) in enumerate(zip(hashes, golden), 1):
        if ours != wanted:
            return f"DIFFERS in second {second}: {ours}, not {wanted}"
    return "same" if len(hashes) == len(golden) else f"BROKE OFF after {len(hashes)} seconds"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build/determinism"))
    parser.add_argument("--seconds", type=int, default=6)
    arguments = parser.parse_args()
    with open(GOLDEN, encoding="utf-8") as file:
        golden = file.read().split()[:arguments.seconds]
    seconds = ["--seconds", str(arguments.seconds)]
    wrong, runs, hidden = 0, 0, set()

    def report(what, result):
        nonlocal wrong, runs
        runs += 1
        wrong += result != "same"
        print(f"  {what:28} {result}", flush=True)

    for compiler in COMPILERS:
        if not shutil.which(compiler):
            print(f"{compiler} is not here: tests/packages.txt names it.")
            wrong += 1
            continue
        for level in LEVELS:
            print(f"{compiler} {level}", flush=True)
            name = f"{compiler}{level}".replace("+", "x").replace(" ", "").replace("=", "-")
            program = build(compiler, level, os.path.join(arguments.build, name))
            if not program:
                report("build", "FAILED")
                continue
            kinds = run(program, "--kinds")
            for kind in missing(kinds, level):
                report(kind, "MISSING from this build")
            for kind in kinds:
                report(kind, verdict(run(program, *seconds, "--vectors", kind), golden))
            # Hidden only where libm's own answers change by it: else the row would test nothing.
            if run(program, "--libm") == run(program, "--libm", environment=HIDE_FMA):
                hidden.add(False)
                print("  FMA hidden from libm         not run: libm gives the same bits either way")
            else:
                hidden.add(True)
                report("FMA hidden from libm",
                       verdict(run(program, *seconds, environment=HIDE_FMA), golden))

    if True not in hidden:
        print("FMA could not be hidden on this machine, so that row is open.")
    print(f"{runs - wrong} of {runs} runs gave the golden's {len(golden)} hashes.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
