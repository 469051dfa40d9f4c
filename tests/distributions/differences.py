#!/usr/bin/env python3
"""Which tests ran in one of two ctest reports (--output-junit) and not in the other. Exit 1 where the second lacks one of the first.
A report may have FIRST.txt beside it: what ONGGI_TESTS_RAN wrote, a line for each test of a program.

usage: differences.py FIRST.xml SECOND.xml
"""

import os
import sys
import xml.etree.ElementTree


def ran(path):
    """Names of the tests that ran."""
    cases = xml.etree.ElementTree.parse(path).getroot().iter("testcase")
    names = {case.get("name") for case in cases if case.get("status") in ("run", "fail")}
    lines = os.path.splitext(path)[0] + ".txt"
    if os.path.isfile(lines):
        with open(lines, encoding="utf-8") as file:
            names |= {line.split()[1] for line in file if line.startswith("ran ")}
    return names


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    names = [os.path.splitext(os.path.basename(path))[0] for path in sys.argv[1:]]
    first, second = (ran(path) for path in sys.argv[1:])
    for here, there, only in ((*names, first - second), (*reversed(names), second - first)):
        print(f"{len(only)} tests ran on {here} and not on {there}{':' if only else '.'}")
        for name in sorted(only):
            print(f"  {name}")
    return 1 if first - second else 0


if __name__ == "__main__":
    sys.exit(main())
