#!/usr/bin/env python3
"""Counts the instructions of 100 ticks of every script under valgrind's callgrind, and compares them
with tests/golden/instructions.txt. A count more than 3 % above its golden fails.

  tests/bench/instructions.py --count build/release/bin/tick_count --compiler "GNU 12.2.0" --config Release
                              [--golden FILE] [--renew "why it may cost more, or costs less now"]

Counts depend on the compiler and on the vectors used, not on the machine's speed or load. So the golden
has a block for each compiler, configuration and kind of vectors. Where it has none for yours, the test
is skipped; --renew writes one.
exit 0: as the golden says, 1: grown, or a count is missing, 77: cannot be counted here (says why)
"""

import argparse
import datetime
import os
import platform
import re
import shutil
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
MOST_GROWTH = 0.03
FUNCTION = "onggi_counted_ticks"
FINER = {"light_touch", "inside_12_mm"}  # these on a finer grid too
ONE_KIND = "as-compiled"  # where the engine has no vectors to choose from
HEADER = """\
# Instructions of 100 ticks: compiler, architecture, configuration, vectors, script, grid, count.
# tests/bench/instructions.py compares and, with --renew "reason", rewrites the counts of its compiler.
"""


def under_valgrind(tool, *words):
    run = subprocess.run(["valgrind", *tool, *words], capture_output=True, text=True)
    if run.returncode:
        raise SystemExit(f"{' '.join(words)} failed under valgrind:\n{run.stderr}")
    return run


def can_count(arguments):
    """Says why, where nothing can be counted."""
    if not shutil.which("valgrind"):
        print("Not counted: valgrind is not here (tests/packages.txt names it).")
        return False
    if arguments.sanitize or arguments.config != "Release":
        print("Not counted: only a Release build without sanitizers says what a tick costs.")
        return False
    return True


def count(program, *words):
    """Instructions within FUNCTION."""
    run = under_valgrind(["--tool=callgrind", "--callgrind-out-file=/dev/null",
                          f"--toggle-collect={FUNCTION}"], program, *words)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if not found or int(found.group(1)) == 0:
        raise SystemExit(f"callgrind counted nothing in {FUNCTION}:\n{run.stderr}")
    return int(found.group(1))


def count_all(program, key):
    """{(compiler, architecture, configuration, vectors, script, grid): instructions}"""
    scripts = subprocess.run([program, "--list"], capture_output=True, text=True,
                             check=True).stdout.split()
    # Asked under valgrind, which knows no wider vectors than AVX2.
    kinds = under_valgrind(["--tool=none", "-q"], program, "--kinds").stdout.split()
    counts = {}
    for kind in kinds or [ONE_KIND]:
        for script in scripts:
            for rows, sectors in [(400, 360)] + ([(1600, 720)] if script in FINER else []):
                words = [script, str(rows), str(sectors)] + ([kind] if kinds else [])
                counts[(*key, kind, script, f"{rows}x{sectors}")] = count(program, *words)
    return counts


def read(path):
    """The golden's counts and its reasons."""
    counts, reasons = {}, []
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            for line in file:
                if line.startswith("# renewed "):
                    reasons.append(line)
                elif line.strip() and not line.startswith("#"):
                    *words, number = line.split()
                    counts[tuple(words)] = int(number)
    return counts, reasons


def write(path, counts, reasons):
    with open(path, "w", encoding="utf-8") as file:
        file.write(HEADER + "".join(reasons))
        for words in sorted(counts):
            file.write(" ".join(words) + f" {counts[words]}\n")


def compare(golden, counts):
    """What is wrong, and what has become cheaper; sentences."""
    wrong, cheaper = [], []
    known = {words[:4] for words in golden}
    for words, now in sorted(counts.items()):
        if words[:4] not in known:
            continue
        name = " ".join(words[3:])
        was = golden.get(words)
        if was is None:
            wrong.append(f"{name}: has no golden.")
        elif now > was * (1 + MOST_GROWTH):
            wrong.append(f"{name}: {was} -> {now} instructions, {100 * (now / was - 1):.1f} % more.")
        elif now < was * (1 - MOST_GROWTH):
            cheaper.append(f"{name}: {was} -> {now} instructions, {100 * (1 - now / was):.1f} % fewer.")
    for words in golden:
        if words[:4] in {w[:4] for w in counts} and words not in counts:
            wrong.append(f"{' '.join(words[3:])}: is in the golden and was not counted.")
    return wrong, cheaper


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", required=True)
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--config", required=True)
    parser.add_argument("--sanitize", default="")
    parser.add_argument("--golden", default=os.path.join(ROOT, "tests/golden/instructions.txt"))
    parser.add_argument("--renew", metavar="REASON")
    arguments = parser.parse_args()
    if not can_count(arguments):
        return 77
    key = (arguments.compiler.replace(" ", "-"), platform.machine(), arguments.config)
    golden, reasons = read(arguments.golden)
    renew = (f'python3 -B tests/bench/instructions.py --count {os.path.relpath(arguments.count, ROOT)} '
             f'--compiler "{arguments.compiler}" --config {arguments.config} --renew "REASON"')
    if arguments.renew is None and not any(words[:3] == key for words in golden):
        print(f"Not compared: the golden has no counts of {' '.join(key)}. To add them:\n{renew}")
        return 77
    counts = count_all(arguments.count, key)
    if arguments.renew is not None:
        reason = " ".join(arguments.renew.split())
        if not reason:
            print("Say why: --renew needs a reason.")
            return 1
        golden = {words: n for words, n in golden.items() if words[:3] != key} | counts
        date = datetime.date.today().isoformat()
        write(arguments.golden, golden, reasons + [f"# renewed {date}, {key[0]}: {reason}\n"])
        print(f"{len(counts)} counts written.")
        return 0
    for kind in sorted({w[3] for w in counts} - {w[3] for w in golden if w[:3] == key}):
        print(f"{kind}: the golden has no counts of these vectors. To add them:\n{renew}")
    compared = [w for w in counts if w[:4] in {g[:4] for g in golden}]
    if not compared:
        return 77
    wrong, cheaper = compare(golden, counts)
    for line in wrong + cheaper:
        print(line)
    if wrong:
        print(f"If the cost is worth it, say why and commit what this writes:\n{renew}")
        return 1
    if cheaper:
        print(f"To hold what was won:\n{renew}")
    print(f"{len(compared)} counts are within {100 * MOST_GROWTH:.0f} % of the golden, or below it.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
