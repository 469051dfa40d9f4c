#!/usr/bin/env python3
"""Measures the exhibit's screens on likely displays (some minutes), and writes the table of kiosk/docs/records/access.md.

  tests/pages/access.py [--bin DIR]    DIR: where onggi-lab lies (default: build/release/bin)
"""

import argparse
import os
import subprocess

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
PAGE = os.path.join(ROOT, "kiosk/docs/records/access.md")
HEAD, END = "<!-- The table is written by tests/pages/access.py. -->\n", "<!-- end of the table -->\n"


def table_in(report):
    """The Markdown lines of what `onggi lab access --displays` prints."""
    return "".join(line for line in report.splitlines(keepends=True) if line.startswith("|"))


def with_table(page, table):
    """`page` with `table` between the two comments that mark its place."""
    before, head, rest = page.partition(HEAD)
    _, end, after = rest.partition(END)
    if not end:
        raise SystemExit(f"The page has no place for the table. Add these two lines where it belongs:\n{HEAD}{END}")
    if not table:
        raise SystemExit("onggi lab access --displays printed no table.")
    return before + head + table + end + after


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=os.path.join(ROOT, "build/release/bin"))
    program = os.path.join(parser.parse_args().bin, "onggi-lab")
    report = subprocess.run([program, "access", "--displays"], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    written = with_table(page, table_in(report.stdout))
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(written)


if __name__ == "__main__":
    main()
