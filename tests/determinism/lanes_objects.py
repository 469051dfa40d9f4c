#!/usr/bin/env python3
"""What is compiled for one kind of vectors shares nothing with the rest: an object of a *_lanes.cpp
may define names of its own namespace only. The linker keeps one copy of a function that several objects
define, and were that the copy for AVX2, processors without AVX2 would stop at it.

  tests/determinism/lanes_objects.py KIND OBJECT...
  exit 0: so it is, 1: not, 77: nm is not here
"""

import shutil
import subprocess
import sys


def foreign(kind, lines):
    """Names that others may define too and that are not of the kind's namespace."""
    found = []
    for line in lines:
        _, letter, name = line.split(" ", 2)
        # Local names (small letters) are the object's own, but for unique and weak ones.
        if letter in "TtrRdDbB" and letter.islower() or f"onggi::{kind}::" in name:
            continue
        found.append(f"{letter} {name}")
    return found


def main():
    kind, *objects = sys.argv[1:]
    if not shutil.which("nm"):
        print("nm is not here: install binutils.")
        return 77
    wrong = 0
    for path in objects:
        out = subprocess.run(["nm", "--defined-only", "--demangle", path], capture_output=True,
                             text=True, check=True).stdout
        for name in foreign(kind, out.splitlines()):
            wrong += 1
            print(f"{path}: {name}\n  may be defined elsewhere too: call nothing of the standard library or"
                  " of a class from a *_lanes.cpp, or give it a function of its own.")
    print(f"{len(objects)} objects for {kind}: {wrong} names that are not theirs alone.")
    return 1 if wrong or not objects else 0


if __name__ == "__main__":
    sys.exit(main())
