#!/usr/bin/env python3
"""What `onggi check` calls good does not stop the exhibit: every value at the ends of what it accepts, and a whole visit on each.

  run.py some                       a control, and texts that are slow to set: for every run of the tests
  run.py every [--only REGEX]       each key at each end, one after the other; each text in each writing; grids, shelves, missions, ways to
                                    decorate; all least, all greatest
  run.py mixes --count N --seed S   N exhibits, each key at one of its ends by chance; S + n writes the n-th again
  run.py names                      the names of `every`, for --only

A visit runs as a service that systemd watches: open the exhibit, choose, throw, decorate, fire, glaze, keep. `onggi check` may refuse a value: then
it says why in a line, and a mix leaves that value out. Else the visit must come to its end, no frame may take more than 0.5 s and no
opening more than 5 s of the processor's time of the frame's thread, and the watchdog must be fed. So a busy machine fails nothing: a frame
that is too long counts if it is so in three visits of three. The wall's time is told too. With --by-the-clock it counts as well, and so
does a silence of more than 10 s, at which systemd ends a service.

exit 0: held, 1: found something, 2: wrong arguments
"""
import argparse
import json
import os
import random
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sites  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LONGEST_FRAME, LONGEST_OPENING, SYSTEMD_WAITS = 0.5, 5.0, 10.0  # s
SOME = (r"control", r"texts=stacked", r"texts=lines")


class Systemd:
    """Listens where systemd would, and notes when the watchdog was fed."""

    def __init__(self, folder):
        self.path = os.path.join(folder, "notify")
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(self.path)
        self.socket.settimeout(0.2)
        self.heard, self.open = [], True
        self.thread = threading.Thread(target=self.listen)
        self.thread.start()

    def listen(self):
        while self.open:
            try:
                words = self.socket.recv(4096)
            except TimeoutError:
                continue
            if b"READY=1" in words or b"WATCHDOG=1" in words:
                self.heard.append(time.monotonic())

    def close(self):
        """How often it was fed, and the longest silence between two times, s."""
        self.open = False
        self.thread.join()
        self.socket.close()
        return len(self.heard), max((b - a for a, b in zip(self.heard, self.heard[1:])), default=0.0)


def environment(folder):
    for name in ("state", "run"):
        os.makedirs(os.path.join(folder, name))
    env = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    env.update(STATE_DIRECTORY=os.path.join(folder, "state"), RUNTIME_DIRECTORY=os.path.join(folder, "run"),
               NOTIFY_SOCKET=os.path.join(folder, "notify"), WATCHDOG_USEC=str(int(SYSTEMD_WAITS * 1e6)), SDL_AUDIODRIVER="dummy")
    return env


def checked(bin_folder, site):
    """What `onggi check` says: None if all is good, else [(file, line, words)]."""
    run = subprocess.run([os.path.join(bin_folder, "onggi"), "check", "--config", site.exhibit], capture_output=True, text=True, timeout=600)
    if run.returncode == 0:
        return None
    found = re.findall(r"^(\S+?\.toml):(\d+)(?::\d+)?[,:]? *(.*)$", run.stdout + run.stderr, re.M)
    return [(file, int(line), words) for file, line, words in found] or [("", 0, (run.stdout + run.stderr)[-300:])]


def written(case, bin_folder, folder):
    """The case as files that check calls good, and what it refused. None for the files if nothing of the case is left."""
    refused = []
    while True:
        site = sites.write(case, ROOT, folder, os.path.join(bin_folder, "onggi"))
        problems = checked(bin_folder, site)
        if problems is None:
            return site, refused
        file, line, words = problems[0]
        refused.append(f"{os.path.basename(file)}:{line} {words}")
        # A vessel's mesh has no line: vessel.toml makes it too large or too small, or it is beyond a limit of the exhibit.
        sized = ("true_height_mm", "true_diameter_mm") if "vessel.toml" in words else ()
        edit = site.edit_at(file, line) if file else next(
            (edit for edit in case.edits if edit[1] == "reader" or edit[2] in sized), None)
        if edit is None or len(refused) > 60:
            raise ValueError(f"check refuses what the case did not write: {refused[-1]}")
        case = case.without(edit)
        if not case.edits:
            return None, refused


def visited(site, mission, bin_folder, folder):
    os.makedirs(folder)
    systemd = Systemd(folder)
    command = [os.path.join(bin_folder, "onggi_ends"), "visit", site.exhibit, os.path.join(folder, "keepsakes"), str(mission)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, env=environment(folder), timeout=1800)
        out = json.loads(run.stdout) if run.returncode == 0 else {"ended": False, "why": f"exit {run.returncode}: {run.stderr[-400:]}"}
        out["log"] = run.stderr
    except subprocess.TimeoutExpired:
        out = {"ended": False, "why": "half an hour was not enough"}
    out["fed"], out["silence"] = systemd.close()
    return out


def faults(visit, by_the_clock):
    found = []
    if not visit["ended"]:
        # The visitor sees that the exhibit fails; why, its log says.
        log = visit.get("log", "").strip().splitlines()[-8:]
        found.append("\n        ".join([f"the visit did not come to its end: {visit['why'].strip()}", *log]))
    if "frame" in visit:
        clock = "wall_s" if by_the_clock else "processor_s"
        frame = max((*visit["slow"], visit["frame"]), key=lambda one: one[clock])
        if frame[clock] > LONGEST_FRAME:
            found.append(f"a frame of {frame[clock]:.2f} s ({frame['at']})")
        for what in ("open", "close"):
            if visit[what][clock] > LONGEST_OPENING:
                found.append(f"to {what} the exhibit took {visit[what][clock]:.1f} s")
        if visit["fed"] < 2 or by_the_clock and visit["silence"] > SYSTEMD_WAITS:
            found.append(f"the watchdog was fed {visit['fed']} times, with {visit['silence']:.1f} s of silence")
    return found


def line_of(name, visit, found):
    if "frame" not in visit or not visit["frames"]:
        return f"FOUND {name}: {'; '.join(found)}"
    frame, wall = visit["frame"], max((*visit["slow"], visit["frame"]), key=lambda one: one["wall_s"])
    return (f"{'FOUND' if found else 'good '} {name}: {visit['frames']} frames, longest {frame['processor_s']:.3f} s of processor "
            f"({frame['at']}), {wall['wall_s']:.3f} s of wall ({wall['at']}); opened in {visit['open']['processor_s']:.2f} s; "
            f"silent {visit['silence']:.1f} s" + "".join(f"\n      {one}" for one in found))


def tried(case, a):
    """True if the case holds."""
    with tempfile.TemporaryDirectory(prefix="onggi-ends") as folder:
        try:
            site, refused = written(case, a.bin, os.path.join(folder, "site"))
        except ValueError as wrong:
            print(f"FOUND {case.name}: {wrong}", flush=True)
            return False
        for words in refused:
            print(f"      {case.name}: refused: {words}")
        if site is None:
            print(f"good  {case.name}: check refuses it", flush=True)
            return True
        visit = visited(site, case.mission, a.bin, os.path.join(folder, "1"))
        found = faults(visit, a.by_the_clock)
        for again in ("2", "3"):  # what the exhibit does comes back; what a busy machine does, not
            if not found or not visit["ended"]:
                break
            visit = min(visit, visited(site, case.mission, a.bin, os.path.join(folder, again)),
                        key=lambda one: one["frame"]["processor_s"] if one["ended"] else 0.0)
            found = faults(visit, a.by_the_clock)
        print(line_of(case.name, visit, found), flush=True)
        if found and a.keep:
            shutil.copytree(site.folder, os.path.join(a.keep, re.sub(r"\W", "_", case.name)), dirs_exist_ok=True)
        a.longest = max(a.longest, visit.get("frame", {"processor_s": 0})["processor_s"])
        return not found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("some", "every", "mixes", "names"))
    parser.add_argument("--bin", default=os.path.join(ROOT, "build/release/bin"))
    parser.add_argument("--only", default="")
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--by-the-clock", action="store_true")
    parser.add_argument("--keep", help="a folder for the sites that something was found with")
    a = parser.parse_args()
    a.longest = 0.0
    run = subprocess.run([os.path.join(a.bin, "onggi_ends"), "keys"], capture_output=True, text=True, check=True)
    keys = json.loads(run.stdout)
    cases = sites.every_case(keys)
    if a.what == "names":
        print("\n".join(case.name for case in cases))
        return 0
    if a.what == "some":
        cases = [case for case in (*cases, sites.mix(keys, 1)) if any(re.fullmatch(one, case.name) for one in SOME)]
    if a.what == "mixes":
        cases = [sites.mix(keys, seed) for seed in range(a.seed, a.seed + a.count)]
    cases = [case for case in cases if re.search(a.only, case.name)]
    found = sum(not tried(case, a) for case in cases)
    print(f"{len(cases)} exhibits at the ends of what check accepts, a whole visit on each: the longest frame took {a.longest:.3f} s of "
          f"the processor; {found} stopped or stalled.")
    return 1 if found or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
