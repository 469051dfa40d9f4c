#!/usr/bin/env python3
"""Broken requests for the staff's page over a real socket, from somebody who is in: nothing in the site changes, nothing is written
outside it, and the page answers afterwards.

usage: python3 -B tests/fuzz/staff_socket.py [--console build/release/bin/onggi-console] [--requests 10000] [--seed 46]
Each is one of the page's own requests with some bytes changed, left out, said twice or said late; some say another length than
they have, or come two in one. Exit: 0 nothing found, 1 something.
"""
import argparse
import collections
import hashlib
import json
import pathlib
import random
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
READ = ["/", "/api/state", "/api/files", "/api/figures?from=2026-05-01&to=2026-05-31", "/api/keepsakes?name=blue", "/keepsake/2026-05-28_141503_moon_jar/postcard.jpg",
        "/api/edit/exhibit", "/api/edit/vessel/moon_jar", "/api/edit/scene/studio", "/api/edit/language/ko", "/api/shelf", "/api/scenes", "/api/revisions", "/api/saved?number=1",
        "/outline/moon_jar", "/api/scan", "/api/people", "/api/changes", "/api/screen?number=1", "/words", "/words/ko", "/words/ko/editors", "/staff.css"]
SENT = [("/api/edit/exhibit/check", {"changes": [["idle.warn_after", 90]]}), ("/api/edit/exhibit/save", {"tag": "0", "changes": [["idle.warn_after", 90]]}),
        ("/api/undo", {"id": "0"}), ("/api/trial/keep", {}), ("/api/people", {"name": "x", "role": "none", "passphrase": "y"}), ("/api/passphrase", {"old": "a", "new": "b"}),
        ("/api/keepsakes/2026-05-28_141503_moon_jar/pass", {}), ("/api/scan/look", {"scan": 9}), ("/api/screen/stop", {}), ("/api/enter", {"name": "a", "passphrase": "b"})]


def broken(request, chance):
    out = bytearray(request)
    for _ in range(chance.choice((1, 1, 2, 4, 16))):
        at, kind = chance.randrange(len(out)), chance.randrange(4)
        if kind == 0:
            out[at] = chance.randrange(256)
        elif kind == 1:
            del out[at:at + chance.randint(1, 40)]
        elif kind == 2:
            out[at:at] = out[at:at + chance.randint(1, 200)]
        else:
            out[at:at] = chance.choice((b"\r\n", b"\0", b"..%2f", b"%00", b"Content-Length: 99999999999\r\n", b"Transfer-Encoding: chunked\r\n", b'{"a":' * 20, "\u202e".encode()))
        if not out:
            out = bytearray(b"\r")
    return bytes(out)


def ask(port, pieces):
    """The first bytes of the answer; the connection is closed then."""
    with socket.create_connection(("127.0.0.1", port), 30) as to:
        to.settimeout(0.1)
        try:
            for piece in pieces:
                to.sendall(piece)
            to.shutdown(socket.SHUT_WR)
            return to.recv(4096)
        except OSError:  # closed, or nothing said
            return b""


def state_of(folder):
    return {str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest() for file in sorted(folder.rglob("*")) if file.is_file()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--console", default=str(ROOT / "build/release/bin/onggi-console"))
    parser.add_argument("--requests", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=46)
    arguments = parser.parse_args()
    chance = random.Random(arguments.seed)
    with tempfile.TemporaryDirectory() as folder:
        around, site = pathlib.Path(folder), pathlib.Path(folder) / "site"
        for name in ("config", "content"):
            shutil.copytree(ROOT / name, site / name)
        visit = site / "keepsakes/2026-05-28_141503_moon_jar"
        visit.mkdir(parents=True)
        shutil.copy(ROOT / "kiosk/docs/pictures/sheet.png", visit / "postcard.jpg")
        console = subprocess.Popen([arguments.console, "--site", site, "--state", around / "state", "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        way_in = re.search(r"http://127.0.0.1:(\d+)(\S+)", console.stdout.readline() + console.stdout.readline())
        port = int(way_in[1])
        host = f"Host: 127.0.0.1:{port}\r\n".encode()
        cookie = re.search(rb"Set-Cookie: ([^;\r]+)", ask(port, [b"GET " + way_in[2].encode() + b" HTTP/1.1\r\n" + host + b"\r\n"]))[1]

        def request(target, body=None):
            sent = json.dumps(body).encode() if body is not None else b""
            head = b"%s %s HTTP/1.1\r\n%sCookie: %s\r\nOrigin: http://127.0.0.1:%d\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n"
            return head % (b"GET" if body is None else b"POST", target.encode(), host, cookie, port, len(sent)) + sent

        before, outside = state_of(site), sorted(file.name for file in around.iterdir())
        answers, began = collections.Counter(), time.monotonic()
        for n in range(arguments.requests):
            asked = request(chance.choice(READ)) if chance.random() < 0.5 else request(*chance.choice(SENT))
            if chance.random() < 0.1:
                asked += request(chance.choice(READ))
            asked = broken(asked, chance) if chance.random() < 0.95 else asked
            cut = chance.randrange(len(asked))
            got = ask(port, [asked[:cut], asked[cut:]] if chance.random() < 0.3 else [asked])
            answers[got[9:12].decode(errors="replace") or "closed"] += 1
            if console.poll() is not None:
                print(f"request {n} ended the program: {asked!r}\n{console.stderr.read()}")
                return 1
        took = time.monotonic() - began
        # What lies there: a pass may have been given, and one who signs in slows the next.
        after = {name: sha for name, sha in state_of(site).items() if not name.startswith("keepsakes/")}
        changed = {name for name in after.keys() | before.keys() if not name.startswith("keepsakes/") and after.get(name) != before.get(name)}
        whole = ask(port, [request("/api/state")]).startswith(b"HTTP/1.1 200")
        rss = int(re.search(r"VmHWM:\s+(\d+)", pathlib.Path(f"/proc/{console.pid}/status").read_text())[1])
        console.terminate()
        console.wait()
        more = sorted(set(file.name for file in around.iterdir()) - set(outside) - {"state"})
        print(f"{arguments.requests:,} requests in {took:.0f} s: {', '.join(f'{count} {code}' for code, count in sorted(answers.items()))}. Most memory {rss / 1024:.0f} MB.")
        print(f"changed: {sorted(changed) or 'nothing'}; beside the site: {more or 'nothing'}; answers afterwards: {whole}")
        return 1 if changed or more or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
