#!/usr/bin/env python3
"""Faults put in for real: what was acknowledged to a visitor must be there afterwards, and the next start must need nobody.

  tests/faults/run.py sweep [--bin DIR] [--kinds EIO ENOSPC ...] [--each N] [--visits 3]
      every thing that keeping does to the disk in turn (makes, writes, syncs, cuts, renames, removes): it fails, once or
      from there on, a write takes half, the program is killed before or after it, the folder is taken away, the clock
      leaps ten years. --each 5: every fifth only.
  tests/faults/run.py kills [--bin DIR] [--times 10000] [--seed 1]
      killed at random moments, again and again in one folder, as a machine whose plug is pulled. Most of a keepsake's
      time goes by while a helper makes pictures and nothing is written: at nineteen of twenty starts a stand-in gives
      those that the helper made once, so that moments fall on what is done to the disk.

After each fault the program runs once more on what is left, with nothing wrong. Looked at: every keepsake that was called
kept is whole to the byte; no folder that is not .partial is less than whole; every visit that was called counted is
counted once; the store is sound and was not set aside; what was half made is gone after an hour; the program that was
not killed came to its end, and refused no more visits than the fault explains.

exit 0: nothing was lost, 1: something was, told with the ONGGI_FAULTS that does it again, 2: it could not be tried
"""

import argparse
import contextlib
import glob
import os
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
FILES = ("postcard.jpg", "pot.glb", "visit.onggi")
TURNING = "turning.gif"  # follows the others: whole, or not there
YEARS = 10 * 365 * 24 * 3600
KINDS = ("EIO", "EIO+", "ENOSPC", "ENOSPC+", "EROFS+", "short", "kill", "killed", "gone",
         f"clock:{YEARS}", f"clock:-{YEARS}")


def plan_of(kind, k):
    """What ONGGI_FAULTS says for it: faults.cpp."""
    if kind.startswith("clock:"):
        return f"clock:{k}:{kind[6:]}"
    return f"{kind.rstrip('+')}:{k}{'+' if kind.endswith('+') else ''}"


class Folder:
    """A folder of keepsakes, and what was promised of it."""

    def __init__(self, path):
        self.path = path
        self.kept, self.counted, self.tried, self.refused = set(), 0, 0, 0
        self.turned = set()

    def heard(self, lines, visits):
        """Takes in what a run of so many visits said. A visit counts as counted once that was said; after a remark
        it may wait for the disk, and is counted if the run came to its end without a word of loss."""
        counted, doubt, lost = 0, False, 0
        for line in lines:
            word, _, rest = line.partition(" ")
            if word == "kept":
                self.kept.add(rest)
            elif word == "turned":
                self.turned.add(rest)
            elif word == "refused":
                self.refused += 1
            elif word == "remark":
                doubt = True
                found = re.search(r"(\d+) visits? that the disk did not take could not be counted", rest)
                lost += int(found.group(1)) if found else 0
            elif word == "counted" and not doubt:
                counted = int(rest)
            elif word == "ended":
                counted = visits - lost
        self.counted += counted
        self.tried += visits

    def wrong(self, whole):
        """What is not as it was promised; `whole` is what the files of a keepsake hold."""
        bad = []
        names = set(os.listdir(self.path)) if os.path.isdir(self.path) else set()
        for name in sorted(self.kept - names):
            bad.append(f"{name} was called kept and is not there")
        for name in sorted(n for n in names if re.match(r"\d{4}-\d\d-\d\d_", n) and not n.endswith(".partial")):
            found = {}
            for file in os.listdir(os.path.join(self.path, name)):
                with open(os.path.join(self.path, name, file), "rb") as f:
                    found[file] = f.read()
            if TURNING not in found and name not in self.turned:
                found[TURNING] = whole[TURNING]
            if found != whole:
                bad.append(f"{name} is not whole: {sorted(k for k in set(found) | set(whole) if found.get(k) != whole.get(k))}")
        bad += [f"{name} was set aside" for name in names if "damaged" in name]
        rows = self.rows()
        if rows is None:
            bad.append("the store is not sound")
        elif not self.counted <= rows <= self.tried:
            bad.append(f"{rows} visits are counted, {self.counted} were called so, {self.tried} there were")
        return bad

    def rows(self):
        try:
            # One that stays open would keep the next start from counting.
            with contextlib.closing(sqlite3.connect(os.path.join(self.path, "onggi.sqlite"))) as db:
                if db.execute("PRAGMA integrity_check").fetchone()[0] != "ok":
                    return None
                return db.execute("SELECT count(*) FROM visits").fetchone()[0]
        except sqlite3.Error:
            return None

    def age_leftovers(self):
        """As if an hour had gone by since."""
        for name in glob.glob(os.path.join(glob.escape(self.path), "*.partial")):
            os.utime(name, (time.time() - 7200,) * 2)

    def leftovers(self):
        return [n for n in os.listdir(self.path) if n.endswith((".partial", ".part"))]


# Reads what onggi-encode would, and gives what that made of the same picture once.
STAND_IN = """#!/bin/sh
read -r head
cat > /dev/null
case $head in
  *'"gif"'*) exec cat '{folder}/turning.gif' ;;
esac
exec cat '{folder}/postcard.jpg'
"""


class Keeper:
    """Keeping without screens: tests/faults/keeper.cpp."""

    def __init__(self, folder):
        self.program = os.path.join(folder, "onggi_faults_keeper")
        self.preload = os.path.join(folder, "onggi_faults.so")
        for path in (self.program, self.preload, os.path.join(folder, "onggi-encode")):
            if not os.path.exists(path):
                raise SystemExit(f"{path} is not built: cmake --build --preset ci --target onggi_faults "
                                 "onggi_faults_keeper onggi-encode")

    def run(self, folder, first, count, plan=None, log=None, kill_after=None):
        """Exit code (negative: the signal) and lines."""
        environment = dict(os.environ)
        if plan or log:
            environment.update(LD_PRELOAD=self.preload, ONGGI_FAULTS_UNDER=folder)
            environment.update({"ONGGI_FAULTS": plan} if plan else {})
            environment.update({"ONGGI_FAULTS_LOG": log} if log else {})
        process = subprocess.Popen([self.program, folder, str(first), str(count)], env=environment, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            out, _ = process.communicate(timeout=kill_after if kill_after is not None else 120)
        except subprocess.TimeoutExpired:
            process.kill()
            out, _ = process.communicate()
        whole_lines = out.split("\n")[:-1]
        return process.returncode, whole_lines

    def reference(self, scratch):
        """What a keepsake holds, and what keeping `visits` does to the disk."""
        folder = os.path.join(scratch, "reference")
        code, lines = self.run(folder, 0, 1)
        if code != 0 or "ended" not in lines:
            raise SystemExit("The keeper does not keep, with nothing wrong: " + " / ".join(lines))
        (name,) = [line[5:] for line in lines if line.startswith("kept ")]
        whole = {}
        for file in (*FILES, TURNING):
            with open(os.path.join(folder, name, file), "rb") as f:
                whole[file] = f.read()
        return whole

    def with_pictures_of(self, keepsake, scratch):
        """The same program beside a stand-in for onggi-encode."""
        folder = os.path.join(scratch, "bin")
        os.makedirs(folder)
        for path in (self.program, self.preload):
            shutil.copy(path, folder)
        helper = os.path.join(folder, "onggi-encode")
        with open(helper, "w", encoding="utf-8") as file:
            file.write(STAND_IN.format(folder=keepsake))
        os.chmod(helper, 0o755)
        return Keeper(folder)

    def things_done(self, scratch, visits):
        log = os.path.join(scratch, "log")
        self.run(os.path.join(scratch, "counted"), 0, visits, log=log)
        with open(log, encoding="utf-8") as file:
            return file.read().splitlines()


def told(plan, problems, counts):
    for problem in problems:
        print(f"ONGGI_FAULTS={plan}: {problem}", flush=True)
    counts["wrong"] += bool(problems)


def one_fault(keeper, scratch, whole, kind, k, visits, done_by):
    """Problems of one fault, and what was kept and refused. `done_by`: for each visit, the last thing done by its end."""
    plan = plan_of(kind, k)
    folder = Folder(os.path.join(scratch, "faulty"))
    shutil.rmtree(folder.path, ignore_errors=True)
    code, lines = keeper.run(folder.path, 0, visits, plan)
    folder.heard(lines, visits)
    problems = []
    killed = kind in ("kill", "killed")
    if killed and code != -signal.SIGKILL:
        problems.append(f"it was to be killed, and came to {code}")
    if not killed and (code != 0 or "ended" not in lines):
        problems.append(f"the program did not come to its end ({code})")
    if not killed and not kind.endswith("+") and folder.refused > 1:
        problems.append(f"{folder.refused} visits were refused for one fault")
    if kind == "gone":  # what was there is gone with the folder; all that came later must be there
        at = next((n for n in range(visits) if done_by[n] >= k), visits)
        for n in range(at + 1, visits):
            if not any(name.endswith(f"_jar_{n:06}") for name in os.listdir(folder.path)):
                problems.append(f"visit {n} was not kept, though it came after")
        folder.kept = {name for name in folder.kept if int(name[-6:]) > at}
        folder.counted = visits - at - 1 if at < visits else 0
    folder.age_leftovers()
    code, lines = keeper.run(folder.path, visits, 1)
    before = folder.counted
    folder.heard(lines, 1)
    if code != 0 or not any(re.fullmatch(rf"kept .*_jar_{visits:06}", line) for line in lines) or folder.counted != before + 1:
        problems.append(f"the next start did not keep and count: {code} {' / '.join(lines)}")
    problems += folder.wrong(whole)
    problems += [f"{name} lies about after an hour" for name in folder.leftovers()]
    return problems, len(folder.kept), folder.refused


def sweep(a, scratch):
    keeper = Keeper(a.bin)
    whole = keeper.reference(scratch)
    things = keeper.things_done(scratch, a.visits)
    done_by = [max(n for n, line in enumerate(things, 1) if f"_jar_{visit:06}" in line) for visit in range(a.visits)]
    every = [(kind, k) for kind in a.kinds for k in range(1 + a.offset, len(things) + 1, a.each)]
    counts = {"wrong": 0, "kept": 0, "refused": 0}
    began = time.monotonic()
    for n, (kind, k) in enumerate(every):
        problems, kept, refused = one_fault(keeper, scratch, whole, kind, k, a.visits, done_by)
        told(plan_of(kind, k) + f" ({things[k - 1]})", problems, counts)
        counts["kept"] += kept
        counts["refused"] += refused
        if n % 100 == 99:
            left = (time.monotonic() - began) / (n + 1) * (len(every) - n - 1)
            print(f"[{n + 1} of {len(every)}, {left / 60:.0f} min left]", flush=True)
    print(f"{len(things)} things that {a.visits} visits do to the disk, {len(every)} faults: {counts['kept']} keepsakes "
          f"called kept, {counts['refused']} refused in words; {counts['wrong']} faults with something lost.")
    return counts["wrong"]


def kills(a, scratch):
    real = Keeper(a.bin)
    whole = real.reference(scratch)
    (made,) = glob.glob(os.path.join(glob.escape(scratch), "reference", "*_jar_000000"))
    quick = real.with_pictures_of(made, scratch)
    draw = random.Random(a.seed)
    length = {}
    folder = Folder(os.path.join(scratch, "killed"))
    wrong, done, first, kept, counted = 0, 0, 0, 0, 0

    def visits(keeper, count, kill_after=None):
        nonlocal first
        code, lines = keeper.run(folder.path, first, count, kill_after=kill_after)
        folder.heard(lines, count)
        first += count
        return code, lines

    began = time.monotonic()
    for n in range(1, a.times + 1):
        if n % 100 == 1:  # how long two take by now: the folder grows, and a machine has other things to do
            if n % 500 == 1:
                kept, counted = kept + len(folder.kept), counted + folder.counted
                folder = Folder(os.path.join(scratch, f"killed{n}"))
            for keeper in (real, quick):
                started = time.monotonic()
                visits(keeper, 2)
                length[keeper] = time.monotonic() - started
        keeper = real if n % 20 == 0 else quick
        done += visits(keeper, 2, draw.uniform(0.0, length[keeper]))[0] == -signal.SIGKILL
        if n % 100 == 0 or n == a.times:
            folder.age_leftovers()
            code, lines = visits(real, 1)
            problems = folder.wrong(whole) + [f"{name} lies about" for name in folder.leftovers()]
            if code != 0 or "ended" not in lines:
                problems.append(f"the next start did not come to its end: {code}")
            for problem in problems:
                print(f"after {n} kills: {problem}", flush=True)
            wrong += len(problems)
            if n % 1000 == 0:
                left = (time.monotonic() - began) / n * (a.times - n)
                print(f"[{n} of {a.times}, {left / 60:.0f} min left] {kept + len(folder.kept)} kept, "
                      f"{counted + folder.counted} counted", flush=True)
    print(f"{a.times} starts, {done} of them killed at a random moment (seed {a.seed}): {kept + len(folder.kept)} keepsakes called "
          f"kept, {counted + folder.counted} visits called counted; {wrong} lost or broken.")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("sweep", "kills"))
    parser.add_argument("--bin", default=os.path.join(ROOT, "build/release/bin"))
    parser.add_argument("--kinds", nargs="+", default=list(KINDS))
    parser.add_argument("--each", type=int, default=1)
    parser.add_argument("--offset", type=int, default=0)
    parser.add_argument("--visits", type=int, default=3)
    parser.add_argument("--times", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=1)
    a = parser.parse_args()
    unknown = [k for k in a.kinds if k not in KINDS]
    if unknown:
        print(f"{' '.join(unknown)}: a kind is one of {' '.join(KINDS)}", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory(prefix="onggi-faults") as scratch:
        return 1 if (sweep if a.what == "sweep" else kills)(a, os.path.realpath(scratch)) else 0


if __name__ == "__main__":
    sys.exit(main())
