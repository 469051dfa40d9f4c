#!/usr/bin/env python3
"""Absent effects leave no bit: an engine built without any effect's stage and the whole one come to
the same state hashes in scenes that have none, and in those whose absent Defs are full of NaN. And to
others where an effect is there, or the first engine would be no different.

  tests/determinism/without_effects.py [--build build/determinism]
  exit 0: all the same, 1: not, or one could not be built
"""

import argparse
import os
import subprocess
import sys

from matrix import ROOT, TELLING, build, folder, verdict

GRID = ["400", "360"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build/determinism"))
    arguments = parser.parse_args()
    compiler, level = TELLING[0]  # matrix.py has compiled its engine already
    whole = build(compiler, level, os.path.join(arguments.build, folder(compiler, level)), target="tick_count")
    without = build(compiler, f"{level} -DONGGI_WITHOUT_EFFECTS",
                    os.path.join(arguments.build, "without_effects"), target="tick_count")
    if not whole or not without:
        return 1

    def said(program, *words):
        return subprocess.run([program, *words], capture_output=True, text=True,
                              check=True).stdout.split()

    kind = (said(whole, "--kinds") or [""])[0]
    effects = said(whole, "--effects")
    wrong = runs = 0

    def report(what, good):
        nonlocal wrong, runs
        runs += 1
        wrong += not good
        if not good:
            print(f"  {what}", flush=True)

    def ticks(program, script, scene):
        return said(program, script, *GRID, kind, scene)

    for script in said(whole, "--list"):
        wanted = ticks(without, script, "bare")
        report(f"{script}, no effect: {verdict(ticks(whole, script, 'bare'), wanted)}",
               ticks(whole, script, "bare") == wanted)
    script = "deep_and_moving"
    wanted = ticks(without, script, "bare")
    for effect in effects:
        report(f"{script}, {effect} absent and full of NaN: DIFFERS",
               ticks(whole, script, "-" + effect) == wanted)
    for effect in ["volume", "propagation", "wobble"]:
        report(f"{script}, {effect} present: the engine without effects has it",
               ticks(whole, script, effect) != ticks(without, script, effect))
    print(f"{runs - wrong} of {runs}: an engine without effects, and one whose effects are absent.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
