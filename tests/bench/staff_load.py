#!/usr/bin/env python3
"""What the wheel notices of the staff's page: the real kiosk throws pots, with the page quiet and with all that can be done to it, by turns.

usage: python3 -B tests/bench/staff_load.py [--bin build/release/bin] [--seconds 30] [--pairs 5] [--seed 46]
Each window is one run of onggi-lab timing, of whose second half (drawing, at 1280x720) the figures are; pairs begin with quiet
and loaded by turns. onggi-console runs with the niceness of its service. Its clients, which in a museum are other machines, run
on idle time. They are, all at once: 256 connections that say nothing, 16 that say a letter each half second, requests of random
bytes, the page's own questions, changes that are checked and saved, a scan that is sent without end, and screens that are drawn.
Prints a table; the goals are in it. Nothing here is a test.
"""
import argparse
import json
import os
import pathlib
import random
import re
import shutil
import socket
import statistics
import subprocess
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOAL = 1.25  # median of the pairs' ratios of p99
NICE = 10  # kiosk/program/package's onggi-console.service


class Page:
    """onggi-console for a copy of the exhibit, and somebody who is in."""

    def __init__(self, programs):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-load-"))
        for name in ("config", "content"):
            shutil.copytree(ROOT / name, self.folder / name)
        self.process = subprocess.Popen(["nice", "-n", str(NICE), programs / "onggi-console", "--site", self.folder, "--state", self.folder / "state", "--listen", "127.0.0.1:0"],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        way_in = re.search(r"http://127.0.0.1:(\d+)(\S+)", self.process.stdout.readline() + self.process.stdout.readline())
        self.port, self.origin = int(way_in[1]), f"http://127.0.0.1:{way_in[1]}"
        self.cookie = ""
        head = self.ask("GET", way_in[2])[0]
        self.cookie = re.search(r"Set-Cookie: ([^;\r]+)", head)[1]

    def connect(self):
        to = socket.create_connection(("127.0.0.1", self.port), 20)
        to.settimeout(20)
        return to

    def head(self, method, target, length=0, kind="application/json"):
        return (f"{method} {target} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nOrigin: {self.origin}\r\nCookie: {self.cookie}\r\n"
                f"Content-Type: {kind}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n").encode()

    def ask(self, method, target, body=None):
        """Head and body of the answer."""
        sent = json.dumps(body).encode() if body is not None else b""
        with self.connect() as to:
            to.sendall(self.head(method, target, len(sent)) + sent)
            got = b""
            while piece := to.recv(65536):
                got += piece
        head, _, text = got.partition(b"\r\n\r\n")
        return head.decode(errors="replace"), text.decode(errors="replace")

    def value(self, method, target, body=None):
        return json.loads(self.ask(method, target, body)[1])

    def close(self):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.folder)


class Load:
    """All that can be done to a page, until it is over; how often each was done."""

    def __init__(self, page, seed):
        self.page, self.chance, self.over, self.counts = page, random.Random(seed), threading.Event(), {}
        works = (self.say_nothing, self.speak_slowly, self.ask_at_random, self.look, self.check, self.save, self.send, self.draw)
        self.threads = [threading.Thread(target=self.again, args=(work,), daemon=True) for work in works]
        for thread in self.threads:
            thread.start()

    def again(self, work):
        os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))  # this thread alone
        while not self.over.is_set():
            try:
                self.counts[work.__name__] = self.counts.get(work.__name__, 0) + work()
            except (OSError, ValueError, KeyError, TypeError):
                self.over.wait(0.05)  # refused, or closed: once more

    def say_nothing(self):
        idle = [self.page.connect() for _ in range(256)]
        self.over.wait(4)
        for one in idle:
            one.close()
        return len(idle)

    def speak_slowly(self):
        slow = [self.page.connect() for _ in range(16)]
        for letter in self.page.head("GET", "/api/state")[:12]:
            for one in slow:
                one.send(bytes([letter]))
            self.over.wait(0.5)
        for one in slow:
            one.close()
        return len(slow)

    def ask_at_random(self):
        with self.page.connect() as to:
            head = bytearray(self.page.head(self.chance.choice(("GET", "POST", "PUT")), "/" + self.chance.choice(("api/state", "api/edit/exhibit", "keepsake/a/b", "api/scan", "x"))))
            for _ in range(self.chance.randint(0, 12)):
                head[self.chance.randrange(len(head))] = self.chance.randrange(256)
            to.sendall(bytes(head))
            to.settimeout(0.2)
            to.recv(4096)
        return 1

    def look(self):
        for target in ("/api/state", "/api/keepsakes?day=2026-05-28", "/api/edit/exhibit", "/api/shelf", "/api/files", "/words/ko"):
            self.page.ask("GET", target)
        return 6

    def check(self):
        self.page.ask("POST", "/api/edit/exhibit/check", {"changes": [["idle.warn_after", self.chance.randint(0, 4000)]]})
        return 1

    def save(self):
        tag = self.page.value("GET", "/api/edit/exhibit")["tag"]
        number = self.page.value("POST", "/api/edit/exhibit/save", {"tag": tag, "changes": [["idle.warn_after", self.chance.randint(20, 3600)]]})["number"]
        while self.page.value("GET", f"/api/saved?number={number}")["under_way"] and not self.over.is_set():
            self.over.wait(0.3)
        return 1

    def send(self):
        piece, all_of_it = bytes(1 << 20), 400 << 20
        with self.page.connect() as to:
            to.sendall(self.page.head("POST", "/api/upload?name=jar.stl&first=1", all_of_it, "application/octet-stream"))
            for sent in range(all_of_it >> 20):
                if self.over.is_set():
                    return sent
                to.sendall(piece)
        return all_of_it >> 20

    def draw(self):
        number = self.page.value("POST", "/api/screen", {"screen": self.chance.choice(("label", "choose", "result"))})["number"]
        while self.page.value("GET", f"/api/screen?number={number}")["drawing"] and not self.over.is_set():
            self.over.wait(0.3)
        return 1

    def end(self):
        self.over.set()
        for thread in self.threads:
            thread.join(30)
        return dict(sorted(self.counts.items()))


def window(programs, seconds):
    """Figures of the kiosk while it throws and draws."""
    said = subprocess.run([programs / "onggi-lab", "timing", "--seconds", str(seconds), "--json", "-"], capture_output=True, text=True, cwd=ROOT)
    return json.loads(said.stdout)["phases"][1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--seed", type=int, default=46)
    arguments = parser.parse_args()
    programs = arguments.bin.resolve()
    print("| pair | page | ticks | missed | wake p99 us | tick p99 us | frame p50 ms |\n|---|---|---|---|---|---|---|", flush=True)
    ratios = {"wake_us": [], "compute_us": []}
    missed = {"quiet": 0, "loaded": 0}
    for pair in range(arguments.pairs):
        found = {}
        for kind in ("quiet", "loaded") if pair % 2 == 0 else ("loaded", "quiet"):
            page = Page(programs)
            load = Load(page, arguments.seed + pair) if kind == "loaded" else None
            time.sleep(1)
            found[kind] = figures = window(programs, arguments.seconds)
            done = load.end() if load else ""
            page.close()
            missed[kind] += figures["misses"]
            print(f"| {pair + 1} | {kind} | {figures['wake_us']['count']:,} | {figures['misses']} | {figures['wake_us']['p99']:.0f} | "
                  f"{figures['compute_us']['p99']:.0f} | {figures['frame_us']['p50'] / 1000:.1f} | {done}", flush=True)
        for name, all_of_them in ratios.items():
            all_of_them.append(found["loaded"][name]["p99"] / found["quiet"][name]["p99"])
    for name, all_of_them in ratios.items():
        middle = statistics.median(all_of_them)
        print(f"{name}: p99 loaded / quiet {', '.join(f'{one:.2f}' for one in all_of_them)}; median {middle:.2f}, goal at most {GOAL}: {'met' if middle <= GOAL else 'missed'}")
    print(f"missed ticks: quiet {missed['quiet']}, loaded {missed['loaded']}")


if __name__ == "__main__":
    main()
