#!/usr/bin/env python3
"""Runs tick_bench and adds its figures to tests/bench/results.csv: date, machine, commit, counter, value.

  tests/bench/record.py [--bench build/release/bin/tick_bench] [--csv tests/bench/results.csv] [--short]
  (--short: a few ticks of everything, to see that it works; the figures mean nothing)
"""

import argparse
import csv
import datetime
import json
import os
import platform
import re
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
HEAD = ["date", "machine", "commit", "counter", "value"]
# What Google Benchmark itself says of a run.
NOT_OURS = {"family_index", "per_family_instance_index", "repetitions", "repetition_index",
            "threads", "iterations", "real_time", "cpu_time"}
OF_A_SCRIPT = ["median_ns", "p99_ns", "p999_ns", "worst_ns", "p999_of_tick", "ns_per_visited"]


def machine():
    """The processor's name and how many of it, which is what the figures depend on."""
    name = platform.processor() or platform.machine()
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        for line in file:
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    return f"{name} x{os.cpu_count()}"


def commit():
    def git(*words):
        return subprocess.run(["git", "-c", "safe.directory=*", *words], cwd=ROOT,
                              capture_output=True, text=True).stdout.strip()
    return (git("rev-parse", "--short=10", "HEAD") or "unknown") + (
        "+changes" if git("status", "--porcelain") else "")


def figures(benchmarks):
    """Every goal's counters; of each script its times and its hash."""
    for benchmark in benchmarks:
        kind, _, rest = benchmark["name"].partition("/")
        if kind == "goal":
            for name, value in benchmark.items():
                if isinstance(value, (int, float)) and name not in NOT_OURS:
                    yield name, f"{value:.6g}"
        elif kind == "script":
            which = "/".join(rest.split("/")[:2])
            for name in OF_A_SCRIPT:
                yield f"{which}/{name}", f"{benchmark[name]:.6g}"
            yield f"{which}/hash", re.match(r"hash=(\w+)", benchmark["label"]).group(1)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bench", default=os.path.join(ROOT, "build/release/bin/tick_bench"))
    parser.add_argument("--csv", default=os.path.join(ROOT, "tests/bench/results.csv"))
    parser.add_argument("--short", action="store_true")
    arguments = parser.parse_args()
    words = ["--benchmark_format=json"] + (["--short"] if arguments.short else [])
    run = subprocess.run([arguments.bench, *words], stdout=subprocess.PIPE, text=True, check=True)
    date = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M")
    fresh = not os.path.exists(arguments.csv) or os.path.getsize(arguments.csv) == 0
    rows = [[date, machine(), commit(), name, value]
            for name, value in figures(json.loads(run.stdout)["benchmarks"])]
    with open(arguments.csv, "a", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows(([HEAD] if fresh else []) + rows)
    for _, _, _, name, value in rows:
        if "/" not in name:
            print(f"{name:44} {value}")
    print(f"{len(rows)} figures added to {os.path.relpath(arguments.csv)}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
