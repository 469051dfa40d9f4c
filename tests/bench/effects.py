#!/usr/bin/env python3
"""What each effect costs, in instructions of 100 ticks, counted under valgrind's callgrind; and that an
absent one costs nothing: within 0.1 % of a scene that has none, and such a scene no more than MOST_TO_ASK
instructions a tick, and not a byte, beyond an engine that was built without any effect. What
engine/docs/effects.md tells of the present ones is held to the counts where the compiler is the one it
tells of, on AVX2.

  tests/bench/effects.py --count build/release/bin/tick_count [--compiler "GNU 12.2.0"] [--config Release]
                         [--without build/release/bin/tick_count_without_effects] [--script light_touch]

exit 0: absent effects are free and the page is right, 1: one is not, 77: cannot be counted here (says why)
"""

import argparse
import os
import re
import subprocess
import sys

from instructions import ONE_KIND, ROOT, can_count, count, under_valgrind

MOST_DIFFERENCE = 0.001
MOST_TO_ASK = 60  # instructions a tick: each stage asks once whether there is anything for it
TICKS = 100
PAGE = os.path.join(ROOT, "engine/docs/effects.md")
TOLD_OF = ("GNU 12.", "avx2", "light_touch")


def told():
    """{effect: percent more} of the page's table."""
    with open(PAGE, encoding="utf-8") as page:
        return {name: int(more)
                for name, more in re.findall(r"^\| `(\w+)` \| (\d+) % \|", page.read(), re.M)}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", required=True)
    parser.add_argument("--compiler", default="GNU 12.2.0")
    parser.add_argument("--config", default="Release")
    parser.add_argument("--sanitize", default="")
    parser.add_argument("--script", default="light_touch")
    parser.add_argument("--without")
    arguments = parser.parse_args()
    if not can_count(arguments):
        return 77
    kinds = under_valgrind(["--tool=none", "-q"], arguments.count, "--kinds").stdout.split()
    words = [arguments.script, "400", "360", kinds[0] if kinds else ""]
    names = subprocess.run([arguments.count, "--effects"], capture_output=True, text=True,
                           check=True).stdout.split()
    base = count(arguments.count, *words, "bare")
    print(f"{arguments.script} 400x360 on {kinds[0] if kinds else ONE_KIND} vectors, 100 ticks")
    print(f"{'none':14} {base:10}")
    wrong = 0
    page = told() if (arguments.compiler[:7], *kinds[:1], arguments.script) == TOLD_OF else None
    if arguments.without:
        asked = (base - count(arguments.without, *words, "bare")) / TICKS
        held = [int(subprocess.run([program, "--bytes"], capture_output=True, text=True,
                                   check=True).stdout) for program in (arguments.count, arguments.without)]
        free = asked <= MOST_TO_ASK and held[0] == held[1]
        wrong += not free
        print(f"beyond an engine without effects: {asked:.1f} instructions a tick, {held[0] - held[1]} bytes of "
              f"{held[0]}{'' if free else '  NOT FREE'}")
        with open(PAGE, encoding="utf-8") as file:
            said = int(re.search(r"takes (\d+) instructions a tick more", file.read()).group(1))
        if page is not None and abs(asked - said) > 5:
            wrong += 1
            print(f"{PAGE} says {said} instructions a tick. Correct it.")
    for name in names:
        absent = count(arguments.count, *words, "-" + name)
        present = count(arguments.count, *words, name)
        free = abs(absent / base - 1) <= MOST_DIFFERENCE
        wrong += not free
        more = 100 * (present / base - 1)
        print(f"{name:14} {present:10}  {more:+6.1f} %   absent: "
              f"{100 * (absent / base - 1):+.3f} %{'' if free else '  NOT FREE'}")
        if page is not None and abs(more - page.get(name, 0)) > 3 + 0.03 * page.get(name, 0):
            wrong += 1
            print(f"{PAGE} says {page.get(name, 0)} % of {name}. Correct it.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
