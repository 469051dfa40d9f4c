#!/usr/bin/env python3
"""Are the tests awake? Changes a sign or a constant in the engine, one at a time, and runs the tests.

  tests/mutation/mutate.py [--each 3] [--most N] [--near N] [--seed 1] [--files engine/contact/*] [--json F]
                             [--keep DIR] [--jobs N]
  tests/mutation/mutate.py --list

Works on a copy of the tracked tree, built without the kiosk. In every file of the rooms contact, effects and
force it chooses places by seed: + and -, < and >, min and max, true and false, && and ||, a number
doubled (0 becomes 1). A change is caught when a test fails, dies or takes ten times its processor time. Changes
that do not compile, or that compile to the same code, are not counted. What nobody noticed is printed with its line.
It takes half a minute a change on one core: an hour and more for all.

--each N   changes a file (default 3)
--most N   of those, N from all files by lot, in the order drawn: what is stopped early is still a fair sample
--near N   ask only the N nearest of the tests' programs: sooner done, and no more than a lower bound
--list     print the changes and make none
--keep DIR the folder to work in, which then stays, so that a second run goes on where the first was stopped
--jobs N   so many copies at once (default 1), each with a build of its own: ccache makes the later ones cheap
--json F   every change and what became of it
exit 0: at least nine of ten were caught, 1: fewer, 2: it could not be tried
"""

import argparse
import filecmp
import fnmatch
import glob
import hashlib
import json
import multiprocessing
import os
import queue
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
ROOMS = ("contact", "effects", "force")
GOAL = 0.9
# The tests that speak of these rooms, the nearest first. Not those that draw, install or count instructions.
PROGRAMS = {
    "contact": ("contact", "scene", "effects", "clay", "script"),
    "effects": ("effects", "scene", "script", "contact", "clay"),
    "force": ("force", "scene", "effects", "contact", "script"),
}
NUMBER = r"(?<![\w.\"])(\d+\.\d*(?:e-?\d+)?f?|\d+e-?\d+|\d+)(?![\w.\"])"
SWAPS = [(r" \+ ", " - "), (r" - ", " + "), (r" \+= ", " -= "), (r" -= ", " += "),
         (r"(?<=[(,= ])-(?=[a-z(])", ""), (r" < ", " > "), (r" > ", " < "), (r" <= ", " >= "),
         (r" >= ", " <= "), (r"\bmin\(", "max("), (r"\bmax\(", "min("), (r"\btrue\b", "false"),
         (r"\bfalse\b", "true"), (r" && ", " || "), (r" \|\| ", " && ")]


def other_number(text):
    if re.fullmatch(r"0(\.0*)?f?", text):
        return {"0": "1"}.get(text, "1.0f" if text.endswith("f") else "1.0")
    if re.fullmatch(r"\d+", text):
        return str(2 * int(text))
    digits = text.rstrip("f")
    return repr(2.0 * float(digits)) + ("f" if text.endswith("f") else "")


def code_of(line):
    """The part of a line in which something may be changed."""
    if re.match(r"\s*(#|//|/\*|template|static_assert|using |namespace|struct |class |return \"|\})", line):
        return ""
    # Beginnings that are written over before they are read.
    if re.match(r"\s*[\w:<>, ]+ \w+ = (0|0\.0f?)(, \w+ = (0|0\.0f?))*;", line):
        return ""
    return line.split("//")[0].split('"')[0]


def places(path):
    """Every (line, begin, end, new text) of a file."""
    out = []
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file):
            code = code_of(line)
            for pattern, new in SWAPS:
                out += [(number, m.start(), m.end(), new) for m in re.finditer(pattern, code)]
            for m in re.finditer(NUMBER, code):
                # An index, a template's argument: an array that is longer than it need be is no fault.
                if code[:m.start()].endswith(("[", "<")) or re.match(r">[\s(]", code[m.end():]):
                    continue
                out.append((number, m.start(), m.end(), other_number(m.group())))
    return sorted(out)


def chosen(tree, each, most, seed, patterns):
    changes = []
    for room in ROOMS:
        found = sorted(glob.glob(f"{tree}/engine/{room}/**/*", recursive=True))
        for path in found:
            name = os.path.relpath(path, tree)
            if not path.endswith((".h", ".cpp")) or not any(fnmatch.fnmatch(name, p) for p in patterns):
                continue
            here = places(path)
            pick = random.Random(f"{seed} {name}")
            lines = set()
            for place in pick.sample(here, len(here)):
                if place[0] not in lines:
                    lines.add(place[0])
                    changes.append((room, name, *place))
                if len(lines) == each:
                    break
    if most:
        random.Random(f"{seed} of all").shuffle(changes)
    return changes[:most or len(changes)]


def copied(tree):
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout
    for name in filter(None, listed.decode().split("\0")):
        source = os.path.join(ROOT, name)
        if os.path.isfile(source):
            target = os.path.join(tree, name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            # What differs is new to the build, though it be older than what was made of a changed one.
            if not os.path.exists(target) or not filecmp.cmp(source, target, shallow=False):
                shutil.copy(source, target)
    shared = os.path.join(os.path.dirname(ROOT), "shared")
    beside = os.path.join(os.path.dirname(tree), "shared")
    if os.path.isdir(shared) and not os.path.exists(beside):
        os.symlink(shared, beside)


def target_of(program):
    return f"onggi_test_engine_{program}"


class Bench:
    """The copy, built; and its tests, each built when those before it noticed nothing."""

    def __init__(self, tree, rooms, near):
        self.programs = {room: PROGRAMS[room][:near] for room in rooms}
        self.tree, self.build = tree, os.path.join(tree, "build")
        if not os.path.exists(os.path.join(self.build, "build.ninja")):
            self.must(["cmake", "-S", tree, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                       "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DONGGI_KIOSK=OFF", "-DONGGI_TESTS=ON",
                       "-DONGGI_WERROR=OFF"])
        programs = sorted({p for ps in self.programs.values() for p in ps})
        self.must(self.make("engine/all", *map(target_of, programs)))
        self.usual = {}
        for program in programs:
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            if self.run(program, 3600):
                raise SystemExit(f"engine/{program}: its tests fail before anything is changed.")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.usual[program] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.code = self.code_now()

    def make(self, *targets):
        return ["cmake", "--build", self.build, "--target", *targets]

    def must(self, command):
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if run.returncode:
            print(run.stdout[-4000:], file=sys.stderr)
            raise SystemExit(2)

    def made(self, target):
        return subprocess.run(self.make(target), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def run(self, program, seconds):
        """Its exit code; of processor time, for beside others a test takes any time by the clock."""
        limit = int(seconds) + 1
        return subprocess.run(
            [os.path.join(self.build, "bin", target_of(program)), "--gtest_fail_fast", "--gtest_brief=1"],
            cwd=self.tree, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))).returncode

    def code_now(self):
        total = hashlib.sha256()
        for path in sorted(glob.glob(f"{self.build}/engine/**/*.o", recursive=True)):
            with open(path, "rb") as file:
                total.update(file.read())
        return total.hexdigest()

    def fate(self, room):
        for program in self.programs[room]:
            if not self.made(target_of(program)):
                return "does not compile"
            code = self.run(program, 10 * self.usual[program] + 5)
            if code == -signal.SIGXCPU:
                return f"caught by engine/{program}, which did not end"
            if code:
                return f"caught by engine/{program}"
        if not self.made("engine/all"):
            return "does not compile"
        if self.code_now() == self.code:
            return "same code"
        return "not noticed"


def result_of(bench, change):
    room, name, number, begin, end, new = change
    path = os.path.join(bench.tree, name)
    with open(path, encoding="utf-8") as file:
        whole = file.read()
    lines = whole.splitlines(keepends=True)
    was = lines[number].strip()
    lines[number] = lines[number][:begin] + new + lines[number][end:]
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write("".join(lines))
        return {"file": name, "line": number + 1, "was": was, "now": lines[number].strip(), "fate": bench.fate(room)}
    finally:
        with open(path, "w", encoding="utf-8") as file:
            file.write(whole)


def work(tree, rooms, near, built, first, changes, results):
    """One copy's part: takes changes until there are none. The first copy is built before the others."""
    try:
        copied(tree)
        if not first:
            built.wait()
        bench = Bench(tree, rooms, near)
        built.set()
        for change in iter(changes.get, None):
            results.put(result_of(bench, change))
    except BaseException as end:  # told, and the others are not left waiting
        print(f"{tree}: {end!r}", file=sys.stderr)
        results.put(None)
    finally:
        built.set()


def known(tree, changes, done):
    """Those of `done` that are among `changes`, and the changes that are not."""
    old, rest = [], []
    for change in changes:
        _, name, number, begin, end, new = change
        with open(os.path.join(tree, name), encoding="utf-8") as file:
            line = file.read().splitlines()[number]
        was, now = line.strip(), (line[:begin] + new + line[end:]).strip()
        match = [d for d in done if (d["file"], d["line"], d["was"], d["now"]) == (name, number + 1, was, now)]
        old += match[:1]
        if not match:
            rest.append(change)
    return old, rest


def next_of(came, workers):
    """The next result; ends the program, and the copies with it, where one of them ended before its work was."""
    while True:
        try:
            result = came.get(timeout=5)
        except queue.Empty:
            result = () if all(w.exitcode in (None, 0) for w in workers) else None
        if result is None:
            for worker in workers:
                worker.terminate()
                worker.join()
            raise SystemExit(2)
        if result:
            return result


def tried(folder, changes, near, jobs, out_path):
    done = []
    if out_path and os.path.exists(out_path):
        with open(out_path, encoding="utf-8") as file:
            done = json.load(file)["changes"]
    results, rest = known(ROOT, changes, done)
    rooms = {room for room, *_ in rest}
    todo, came, built = multiprocessing.Queue(), multiprocessing.Queue(), multiprocessing.Event()
    for change in rest + [None] * jobs:
        todo.put(change)
    workers = [multiprocessing.Process(target=work, daemon=True, args=(
        os.path.join(folder, f"copy{k}", "tree"), rooms, near, built, k == 0, todo, came)) for k in range(jobs)]
    for worker in workers if rest else []:
        worker.start()
    began = time.monotonic()
    for count in range(1, len(rest) + 1):
        result = next_of(came, workers)
        results.append(result)
        left = (time.monotonic() - began) / count * (len(rest) - count)
        print(f"[{len(results)} of {len(changes)}, {left / 60:.0f} min left] {result['file']}:{result['line']}  "
              f"{result['now']}  {result['fate']}", flush=True)
        if out_path:
            with open(out_path, "w", encoding="utf-8") as file:
                json.dump({"changes": results}, file, indent=1)
    return results


def told(results):
    counted = [r for r in results if r["fate"] not in ("does not compile", "same code")]
    missed = [r for r in counted if r["fate"] == "not noticed"]
    for r in missed:
        print(f"\n{r['file']}:{r['line']}\n  was {r['was']}\n  now {r['now']}")
    caught = len(counted) - len(missed)
    share = caught / len(counted) if counted else 0.0
    print(f"\n{caught} of {len(counted)} changes were caught ({100 * share:.0f} %; the goal is {100 * GOAL:.0f} %); "
          f"{len(results) - len(counted)} did not compile or changed no code.")
    return 0 if share >= GOAL else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--each", type=int, default=3)
    parser.add_argument("--most", type=int)
    parser.add_argument("--near", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--files", nargs="+", default=["engine/*"])
    parser.add_argument("--json")
    parser.add_argument("--keep")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    a = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))  # a changed file is put back all the same
    if a.list:
        for room, name, number, begin, end, new in chosen(ROOT, a.each, a.most, a.seed, a.files):
            print(f"{name}:{number + 1}:{begin + 1}: {new.strip()}")
        return 0
    with tempfile.TemporaryDirectory(prefix="onggi-mutation") as temporary:
        changes = chosen(ROOT, a.each, a.most, a.seed, a.files)
        if not changes:
            print(f"no file matches {' '.join(a.files)}: try engine/contact/*", file=sys.stderr)
            return 2
        folder = os.path.realpath(a.keep or temporary)
        return told(tried(folder, changes, a.near, max(1, min(a.jobs, len(changes))), a.json))


if __name__ == "__main__":
    sys.exit(main())
