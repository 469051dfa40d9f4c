#!/usr/bin/env python3
"""Does the time of an answer tell what a token is? Asks a real onggi-console over real sockets for tokens that are wrong,
wrong in the last letter only, expired, deleted and never given, and for another path, in a random order, and compares how
long each took. A wall clock proves nothing in a test, so this is none: that each costs the same work is counted by
tests/kiosk/keepsake/souvenir/pass_test.cpp.

usage: python3 -B tests/kiosk/keepsake/phone/timing.py [--console build/release/bin/onggi-console] [--each 4000] [--seed 1]
Per kind: the median and the quartiles in microseconds; how far its median is from that of wrong tokens, with the range that
95 of 100 resamples stay in; and how often an answer of this kind takes longer than one to a wrong token (50 %: tells nothing).
"""
import argparse
import bisect
import pathlib
import random
import re
import shutil
import socket
import statistics
import subprocess
import tempfile
import time

LETTERS = "abcdefghijkmnpqrstuvwxyz23456789"


def token(chance):
    return "".join(chance.choices(LETTERS, k=26))


def asked(port, target):
    begun = time.perf_counter()
    with socket.create_connection(("127.0.0.1", port)) as phone:
        phone.sendall(f"GET {target} HTTP/1.1\r\nHost: kiosk\r\n\r\n".encode())
        heard = b""
        while more := phone.recv(65536):
            heard += more
    return time.perf_counter() - begun, heard


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--console", default="build/release/bin/onggi-console")
    parser.add_argument("--each", type=int, default=4000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    chance = random.Random(arguments.seed)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-timing-"))
    visits = [folder / f"2026-05-04_1415{n:02d}_jar" for n in range(40)]
    for visit in visits:
        visit.mkdir()

    def given(visit, hours):
        return subprocess.run([arguments.console, "--pass", str(visit), "--hours", str(hours)], check=True,
                              capture_output=True, text=True).stdout.strip()

    good = [given(visit, 24) for visit in visits]
    server = subprocess.Popen([arguments.console, "--phone-only", "--keepsakes", str(folder), "--listen", "127.0.0.1:0"],
                              stdout=subprocess.PIPE, text=True)
    try:
        port = int(re.search(r"port (\d+)", server.stdout.readline())[1])
        deleted = [given(visits[-1], 24) for _ in range(4)]
        with socket.create_connection(("127.0.0.1", port)) as phone:
            phone.sendall(f"POST {deleted[0]}/delete HTTP/1.1\r\nHost: kiosk\r\n\r\n".encode())
            assert b" 200 " in phone.recv(4096)
        expired, renewed = [], -1e9
        times, answers = {}, set()
        order = [kind for kind in ("wrong", "last letter", "expired", "deleted", "never given", "another path")
                 for _ in range(arguments.each)]
        chance.shuffle(order)
        # Of each kind four, asked again and again: what is asked often is warm in every cache.
        wrongs, nevers, paths = ([token(chance) for _ in range(4)] for _ in range(3))
        nears = [each[:-1] + chance.choice([c for c in LETTERS if c != each[-1]]) for each in chance.sample(good[:-1], 4)]
        for kind in order:
            # Once a minute the console forgets passes that have expired: then they are as never given.
            if time.monotonic() - renewed > 20:
                expired = [given(visits[0], 0.0003) for _ in range(4)]
                time.sleep(1.5)
                renewed = time.monotonic()
            target = {"wrong": "/k/" + chance.choice(wrongs), "last letter": chance.choice(nears),
                      "expired": chance.choice(expired), "deleted": chance.choice(deleted),
                      "never given": "/k/" + chance.choice(nevers), "another path": "/x/" + chance.choice(paths)}[kind]
            took, heard = asked(port, target)
            times.setdefault(kind, []).append(1e6 * took)
            answers.add(heard)
    finally:
        server.terminate()
        server.wait()
        shutil.rmtree(folder)
    print(f"{len(order)} answers, {len(answers)} kind{'s' if len(answers) > 1 else ''} of bytes; seed {arguments.seed}")
    wrong = sorted(times["wrong"])
    for kind, took in times.items():
        took.sort()
        quarter = len(took) // 4
        gaps = sorted(statistics.median(chance.choices(took, k=len(took))) - statistics.median(chance.choices(wrong, k=len(wrong)))
                      for _ in range(400))
        longer = sum(bisect.bisect_left(wrong, t) + bisect.bisect_right(wrong, t) for t in took) / (2 * len(took) * len(wrong))
        print(f"{kind:>13}: {took[2 * quarter]:7.1f} us ({took[quarter]:.1f} to {took[3 * quarter]:.1f}); "
              f"{took[2 * quarter] - wrong[len(wrong) // 2]:+6.2f} us ({gaps[10]:+.2f} to {gaps[389]:+.2f}); longer in {100 * longer:.1f} %")


if __name__ == "__main__":
    main()
