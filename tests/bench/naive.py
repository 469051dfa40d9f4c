#!/usr/bin/env python3
"""What people who never threw make of it: naive visits over the shelf, and what came of them.

  tests/bench/naive.py [--seeds 20] [--seconds 90] [--hands mouse] [--vessels moon_jar ...]
                       [--program build/release/bin/onggi] [--config F] [--json F] [--keep DIR]

Every vessel of the shelf is thrown by the naive hands of every seed (kiosk/measure/naive_hands.h), two visits at a
time, and a table says what the median visitor of each goes home with: points, stars, roughness (RMS of the outline about its own
mean over 10 mm), ledge, and when the pot first was handsome (roughness under 0.3 mm, no ledge over 2 mm).
Goals in the default scene: median of all at least 75 points, of no vessel below 60, roughness under 0.3 mm.
Some ten seconds a visit: all of it takes 20 minutes and more. --keep leaves every visit's pictures in DIR.
exit 0: told (goals are printed, not judged), 2: a visit failed
"""

import argparse
import concurrent.futures
import json
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))


def visit(program, folder, vessel, seed, arguments):
    out = os.path.join(folder, f"{vessel}_{seed}")
    command = [program, "visit", "--script", "naive", "--vessel", vessel, "--seed", str(seed),
               "--seconds", str(arguments.seconds), "--hands", arguments.hands, "--out", out]
    if arguments.config:
        command += ["--config", arguments.config]
    run = subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if run.returncode:
        raise RuntimeError(f"{' '.join(command)}\n{run.stderr[-1000:]}")
    with open(os.path.join(out, "visit.json"), encoding="utf-8") as file:
        report = json.load(file)
    return {"vessel": vessel, "seed": seed, "points": report["score"], "stars": report["stars"], **report["naive"]}


def line(name, visits):
    times = [v["handsome_at"] for v in visits if v["handsome_at"] is not None]
    when = f"{statistics.median(times):5.0f} s ({len(times)} of {len(visits)})" if times else "never"
    middle = lambda key: statistics.median(v[key] for v in visits)
    return (f"{name:22} {middle('points'):6.1f} {min(v['points'] for v in visits):6.1f} {middle('stars'):5.0f} "
            f"{1000 * middle('roughness'):9.2f} {1000 * middle('ledge'):8.2f}   {when}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=90)
    parser.add_argument("--hands", default="mouse", choices=["mouse", "finger"])
    parser.add_argument("--vessels", nargs="+")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bin/onggi"))
    parser.add_argument("--config")
    parser.add_argument("--json")
    parser.add_argument("--keep")
    a = parser.parse_args()
    vessels = a.vessels or sorted(os.listdir(os.path.join(ROOT, "content/vessels")))
    wanted = [(vessel, seed) for vessel in vessels for seed in range(1, a.seeds + 1)]
    visits = []
    with tempfile.TemporaryDirectory(prefix="onggi-naive") as temporary:
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            going = [pool.submit(visit, os.path.realpath(a.program), a.keep or temporary, v, s, a) for v, s in wanted]
            for n, one in enumerate(going, 1):
                try:
                    visits.append(one.result())
                except RuntimeError as failed:
                    print(failed, file=sys.stderr)
                    return 2
                print(f"\r{n} of {len(wanted)} visits", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    print(f"{'':22} points  least stars rough, mm ledge, mm  handsome after")
    for vessel in vessels:
        print(line(vessel, [v for v in visits if v["vessel"] == vessel]))
    print(line("all", visits))
    if a.json:
        with open(a.json, "w", encoding="utf-8") as file:
            json.dump({"seconds": a.seconds, "hands": a.hands, "visits": visits}, file, indent=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
