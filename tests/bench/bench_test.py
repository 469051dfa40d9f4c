#!/usr/bin/env python3
"""Runs tick_bench --short and looks whether all of its figures are there, and whether README.md tells the
goals that the program has. Never at how fast they are.

  tests/bench/bench_test.py PATH/TO/tick_bench
"""

import json
import math
import os
import re
import subprocess
import sys

PAGE = os.path.join(os.path.dirname(os.path.realpath(__file__)), "README.md")
# By a name's beginning: what only a build with the kiosk measures, and what may be below 0.
OF_SCENES = ("p999_us_400x360_", "p999_us_6400x2880_studio", "asleep_")
ANY_SIGN = ("asleep_ns_more_",)
OF_EACH_SCRIPT = ["median_ns", "p99_ns", "p999_ns", "worst_ns"]
GRIDS = ["400x360", "1600x720", "6400x2880"]


def main():
    run = subprocess.run([sys.argv[1], "--short", "--benchmark_format=json"],
                         capture_output=True, text=True, check=True)
    with_openvdb = "built without OpenVDB" not in run.stderr
    with_scenes = "built without the kiosk" not in run.stderr
    goals = [line.split() for line in
             subprocess.run([sys.argv[1], "--goals"], capture_output=True, text=True, check=True)
             .stdout.splitlines()]
    wanted = [name for name, _, _ in goals
              if (with_openvdb or name != "ratio_openvdb")
              and (with_scenes or not name.startswith(OF_SCENES))]
    benchmarks = json.loads(run.stdout)["benchmarks"]
    wrong = [f"{b['name']}: {b['error_message']}" for b in benchmarks if b.get("error_occurred")]
    with open(PAGE, encoding="utf-8") as file:
        told = re.findall(r"^\| `(\w+)` \| ([<>]=) (\S+) \|", file.read(), re.M)
    if sorted(told) != sorted(tuple(goal) for goal in goals):
        wrong.append(f"{PAGE} and goal_list.cpp want different things: "
                     f"{sorted(set(told) ^ {tuple(goal) for goal in goals})}")
    seen = {}
    scripts = 0
    for benchmark in benchmarks:
        seen.update((name, benchmark[name]) for name in wanted if name in benchmark)
        if not benchmark["name"].startswith("script/"):
            continue
        scripts += 1
        # A hand that is clear of the clay looks at nothing.
        looks = ["ns_per_visited"] if benchmark.get("visited", 1) > 0 else []
        for name in OF_EACH_SCRIPT + looks:
            if not benchmark.get(name, 0) > 0 or not math.isfinite(benchmark[name]):
                wrong.append(f"{benchmark['name']}: {name} is missing or not above 0.")
        # A tool clear of the clay need not look at any element.
        if (benchmark.get("ns_per_visited", 0) > 0) != (benchmark.get("visited", 0) > 0):
            wrong.append(f"{benchmark['name']}: ns_per_visited does not go with visited.")
        if not re.match(r"hash=[0-9a-f]{16} ", benchmark.get("label", "")):
            wrong.append(f"{benchmark['name']}: no state hash.")
        if not any(f"/{grid}/" in benchmark["name"] for grid in GRIDS):
            wrong.append(f"{benchmark['name']}: of a grid that is not one of {', '.join(GRIDS)}.")
    for name in wanted:
        if name not in seen or not math.isfinite(seen[name]):
            wrong.append(f"{name} is missing.")
        elif not seen[name] > 0 and not name.startswith(ANY_SIGN):
            wrong.append(f"{name} is not above 0.")
    # Bytes are no matter of time, so here the goal itself is kept.
    if seen.get("bytes_per_element_paper_scene", 0) > 12:
        wrong.append("The paper's scene keeps more than 12 bytes an element.")
    if scripts == 0 or scripts % len(GRIDS):
        wrong.append(f"{scripts} scripts were run, which is not all of them on {len(GRIDS)} grids.")
    print("\n".join(wrong) or f"{len(wanted)} goals and {scripts} scripts have their figures"
          + ("." if with_openvdb else ", without OpenVDB: ratio_openvdb is skipped."))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
