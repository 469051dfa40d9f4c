#!/usr/bin/env python3
"""Absent effects leave no bit: an engine built without any effect's stage and the whole one come to
the same state hashes in scenes that have none, and in those whose absent Defs are full of NaN. And to
others where an effect is there, or the first engine would be no different.

  tests/determinism/without_effects.py [--bin build/release/bin]
  exit 0: all the same, 1: not, or one is not built

Both are the Release that tests/bench counts the instructions of: tick_count, and tick_count_without_effects, whose scenes are
compiled with -DONGGI_WITHOUT_EFFECTS (engine/effects/built.h). tests/run builds them.
"""

import argparse
import os
import subprocess
import sys

from matrix import ROOT, verdict

GRID = ["400", "360"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=os.path.join(ROOT, "build/release/bin"))
    arguments = parser.parse_args()
    whole, without = (os.path.join(arguments.bin, name) for name in ("tick_count", "tick_count_without_effects"))
    for program in (whole, without):
        if not os.path.isfile(program):
            print(f"{program} is not built. Build it: cmake --preset ci && cmake --build --preset ci")
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
