#!/usr/bin/env python3
"""What compiling costs: processor time of every file, from nothing, without ccache.

  tests/bench/build_time.py [--most 20] [--keep DIR]

Configures and builds as `bash kiosk/start` does (the targets onggi and onggi-encode), then what
`bash tests/run` adds to it, in a folder of its own. Prints for each the processor time, the time by the
clock, and the dearest files. Time is the compilers' own, user and system, so that other work on the
machine counts little; nothing else should be compiled beside it all the same.
--keep: the folder to build in, which then stays (default: a temporary one)
exit 0: built, 1: not
"""

import argparse
import os
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
STEPS = [("kiosk/start", "OFF", ["onggi", "onggi-encode"]), ("tests/run adds", "ON", ["all"])]

# Stands before every compiler call: writes what it cost, and which file it was for.
LAUNCHER = """\
import os, resource, subprocess, sys
code = subprocess.run(sys.argv[2:]).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
source = sys.argv[sys.argv.index("-c") + 1] if "-c" in sys.argv else "linking"
with open(sys.argv[1], "a", encoding="utf-8") as log:
    log.write(f"{used.ru_utime + used.ru_stime:.3f} {source}\\n")
sys.exit(code)
"""


def build(folder, log, tests, targets):
    launcher = os.path.join(folder, "launcher.py")
    with open(launcher, "w", encoding="utf-8") as file:
        file.write(LAUNCHER)
    words = ";".join([sys.executable, launcher, log])
    for command in (["cmake", "--preset", "release", "-B", folder, f"-DONGGI_TESTS={tests}",
                     f"-DCMAKE_CXX_COMPILER_LAUNCHER={words}"],
                    ["cmake", "--build", folder, "--target", *targets]):
        run = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if run.returncode:
            raise SystemExit(f"{shlex.join(command)} failed:\n{run.stdout[-4000:]}")


def measure(folder, most):
    for name, tests, targets in STEPS:
        log = os.path.join(folder, name.split()[0].replace("/", "_") + ".log")
        started = time.monotonic()
        build(folder, log, tests, targets)
        clock = time.monotonic() - started
        files = {}
        if os.path.exists(log):
            with open(log, encoding="utf-8") as lines:
                for line in lines:
                    seconds, source = line.split(" ", 1)
                    source = os.path.relpath(source.strip(), ROOT)
                    files[source] = files.get(source, 0.0) + float(seconds)
        total = sum(files.values())
        print(f"{name}: {total:.0f} s of processor time, {clock:.0f} s by the clock on "
              f"{os.cpu_count()} cores, {len(files)} files", flush=True)
        for source, seconds in sorted(files.items(), key=lambda item: -item[1])[:most]:
            print(f"  {seconds:6.1f} s  {source}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--most", type=int, default=20)
    parser.add_argument("--keep")
    arguments = parser.parse_args()
    if arguments.keep:
        os.makedirs(arguments.keep, exist_ok=True)
        measure(os.path.realpath(arguments.keep), arguments.most)
    else:
        with tempfile.TemporaryDirectory(prefix="onggi-build-time") as folder:
            measure(folder, arguments.most)
    return 0


if __name__ == "__main__":
    sys.exit(main())
