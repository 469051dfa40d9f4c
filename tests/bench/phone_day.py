#!/usr/bin/env python3
"""A museum's day at the page for the phone, measured: a real onggi-console, real sockets of this machine.

usage: python3 -B tests/bench/phone_day.py [pages] [idle] [addresses] [stalled] [phones] [slow] [memory]   (all of them without a name)
       [--console build/release/bin/onggi-console] [--passes 10000] [--idle 1000] [--phones 64] [--rate 1.0] [--downloads 500]
       [--seconds 70] [--slow 0.1] [--stalled 8000] [--addresses 18000] [--seed 1]
  pages   what a page takes with few passes, with --passes, and while that many expired ones are removed; the console tidies
          at its start and after a minute
  idle    what a visitor's page takes beside --idle connections that say nothing and are opened anew as they end
  addresses  what a visitor's page takes beside --addresses connections that say nothing, each of an address of its own, given up after 4 s
          and opened anew: more than the console takes at once
  stalled what a visitor's page takes from another address beside --stalled downloads of pot.stl that take nothing, given up and opened anew
  phones  --phones phones at --rate MB/s each open a page's five files at once, beside the idle ones
  slow    pot.stl (4.8 MB) at --slow MB/s, in one go, and over a way that breaks after each 0.4 MB; and a page's five files
  memory  the most resident memory of the console in --downloads parallel downloads of pot.stl
Prints a table; the goals are in it. Nothing here is a test: tests look at work, bytes and who is closed.
"""
import argparse
import array
import asyncio
import collections
import contextlib
import hashlib
import json
import pathlib
import random
import re
import resource
import shutil
import socket
import struct
import subprocess
import tempfile
import threading
import time

LETTERS = "abcdefghijkmnpqrstuvwxyz23456789"
# As kiosk/docs/records/keepsake.md weighs a moon jar's folder.
SIZES = {"postcard.jpg": 280_000, "turning.gif": 1_200_000}
CORNERS, TRIANGLES = 48_600, 95_760  # of its model, of which the STL is made
OF_A_PAGE = ("", "/page.css", "/page.js", "postcard.jpg", "pot.glb")


def row(what, figure, goal=""):
    print(f"| {what} | {figure} | {goal} |", flush=True)


def spread(times):
    """Median, p99 and worst in ms."""
    times = sorted(times)
    at = lambda share: 1e3 * times[min(int(share * len(times)), len(times) - 1)]
    return at(0.5), at(0.99), 1e3 * times[-1]


def said(times):
    return "median {:.1f} ms, p99 {:.1f} ms, worst {:.1f} ms".format(*spread(times)) + f", {len(times)} pages"


def model(chance):
    """A GLB as large as a kept pot's."""
    positions = array.array("f", (chance.uniform(-0.1, 0.1) for _ in range(3 * CORNERS))).tobytes()
    indices = array.array("H", (min(n // 2 + n % 3, CORNERS - 1) for n in range(3 * TRIANGLES))).tobytes()
    views = [positions, chance.randbytes(20 * CORNERS), indices]
    at = [sum(map(len, views[:n])) for n in range(4)]
    head = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": at[3]}],
            "bufferViews": [{"buffer": 0, "byteOffset": at[n], "byteLength": len(view)} for n, view in enumerate(views)],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": CORNERS, "type": "VEC3"},
                          {"bufferView": 2, "componentType": 5123, "count": 3 * TRIANGLES, "type": "SCALAR"}],
            "meshes": [{"name": "pot", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]}
    text = json.dumps(head).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<5I", 0x46546C67, 2, 28 + len(text) + at[3], len(text), 0x4E4F534A) + text +
            struct.pack("<2I", at[3], 0x004E4942) + b"".join(views))


class Museum:
    """A folder of keepsakes and a console that serves it."""

    def __init__(self, visits=4):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-day-"))
        self.chance = random.Random(ARGUMENTS.seed)
        self.visits = [f"2026-05-04_{n:06d}_jar" for n in range(visits)]
        content = {name: self.chance.randbytes(size) for name, size in SIZES.items()} | {"pot.glb": model(self.chance)}
        self.bytes = {name: Taken(each) for name, each in content.items()}
        (self.folder / "phone").mkdir()
        for n, visit in enumerate(self.visits):
            (self.folder / visit).mkdir()
            for name, each in content.items() if n == 0 else []:
                (self.folder / visit / name).write_bytes(each)
        printed = self.folder / "desk.stl"
        subprocess.run([ARGUMENTS.console, "--stl", self.folder / self.visits[0], "--to", printed], check=True, capture_output=True)
        self.bytes["pot.stl"] = Taken(printed.read_bytes())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
        self.server.stdout.close()
        shutil.rmtree(self.folder)

    def give(self, count, hours=24.0):
        """Passes, written as the kiosk writes them."""
        now, tokens = int(time.time()), []
        for n in range(count):
            token, counted = ("".join(self.chance.choices(LETTERS, k=26)) for _ in range(2))
            visit = self.visits[n % len(self.visits)]
            # Expired ones came one after the other: a leap of the clock alone ends none.
            begun = now - (0 if hours > 0 else 7200 + n % 7200)
            (self.folder / "phone" / token).write_text(f"{visit}\n{begun}\n{int(begun + abs(hours) * 3600)}\nen\n{counted}\n")
            tokens.append(token)
        return tokens

    def serve(self):
        self.server = subprocess.Popen([ARGUMENTS.console, "--phone-only", "--keepsakes", str(self.folder), "--listen", "127.0.0.1:0"],
                                       stdout=subprocess.PIPE, text=True)
        self.port = int(re.search(r"port (\d+)", self.server.stdout.readline())[1])

    def resident(self):
        text = pathlib.Path(f"/proc/{self.server.pid}/status").read_text()
        return 1024 * int(re.search(r"VmRSS:\s+(\d+)", text)[1]), 1024 * int(re.search(r"VmHWM:\s+(\d+)", text)[1])


async def get(port, target, rate=None, more="", address="127.0.0.1", stop=None, into=None):
    """Status, and what was taken of the body, as a hash that goes on from `into`. `rate`: waits for its turn. `stop`: away after
    so many bytes."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port, local_addr=(address, 0), limit=32768)
    try:
        writer.write(f"GET {target} HTTP/1.1\r\nHost: kiosk\r\n{more}\r\n".encode())
        head = await reader.readuntil(b"\r\n\r\n")
        size, taken = int(re.search(rb"(?i)content-length: (\d+)", head)[1]), into or Taken()
        while size > 0 and (stop is None or stop > 0):
            part = await reader.read(min(size, 32768))
            if not part:
                break
            if rate:
                await rate(len(part))
            taken.add(part)
            size -= len(part)
            stop = None if stop is None else stop - len(part)
        return int(head.split()[1]), taken
    finally:
        writer.close()


class Taken:
    """Bytes that came, counted and hashed: five hundred files are too many to hold."""

    def __init__(self, content=b""):
        self.size, self.hash = 0, hashlib.sha1(usedforsecurity=False)
        self.add(content)

    def add(self, part):
        self.size += len(part)
        self.hash.update(part)

    def __eq__(self, other):
        return self.size == other.size and self.hash.digest() == other.hash.digest()


class Rate:
    """So many bytes a second, for all that share it."""

    def __init__(self, bytes_a_second):
        self.a_second, self.free = bytes_a_second, time.monotonic()

    async def __call__(self, count):
        self.free = max(self.free, time.monotonic()) + count / self.a_second
        await asyncio.sleep(max(0.0, self.free - time.monotonic()))


async def idle(port, count):
    """Connections that say nothing and are opened anew as they end; a generator of their tasks."""
    async def one():
        while True:
            with contextlib.suppress(OSError):
                reader, writer = await asyncio.open_connection("127.0.0.1", port)
                await reader.read(1)
                writer.close()
            await asyncio.sleep(0.01)
    tasks = [asyncio.create_task(one()) for _ in range(count)]
    await asyncio.sleep(2)
    return tasks


async def ended(tasks):
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)


async def pages_of(museum, tokens, seconds, address="127.0.0.1", pause=0.005):
    """What each page took, and how many were not served."""
    times, lost, end = [], 0, time.monotonic() + seconds
    while time.monotonic() < end:
        begun = time.monotonic()
        try:
            status, _ = await asyncio.wait_for(get(museum.port, "/k/" + museum.chance.choice(tokens), address=address), 20)
            lost += status != 200
        except (OSError, asyncio.IncompleteReadError, asyncio.TimeoutError):
            lost += 1
        times.append(time.monotonic() - begun)
        await asyncio.sleep(pause)
    return times, lost


async def pages():
    p99 = {}
    for what, count, expired in (("10 passes", 10, 0), (f"{ARGUMENTS.passes} passes", ARGUMENTS.passes, 0),
                                 (f"10 passes, and {ARGUMENTS.passes} expired ones removed at the start", 10, ARGUMENTS.passes)):
        with Museum(100) as museum:
            tokens = museum.give(count)
            museum.give(expired, -1)
            museum.serve()
            times, lost = await pages_of(museum, tokens, ARGUMENTS.seconds)
            row(f"a page, {what}; {lost} not served", said(times), "p99 < 50 ms")
            p99[what] = spread(times)[1]
    few, many, _ = p99.values()
    row(f"p99 with {ARGUMENTS.passes} passes / with 10", f"{many / few:.1f}")


async def idle_ones():
    with Museum() as museum:
        tokens = museum.give(50)
        museum.serve()
        alone, _ = await pages_of(museum, tokens, 5)
        tasks = await idle(museum.port, ARGUMENTS.idle)
        for address in ("127.0.0.2", "127.0.0.1"):
            times, lost = await pages_of(museum, tokens, 15, address)
            whose = "the same" if address == "127.0.0.1" else "another"
            row(f"a page from {whose} address beside {ARGUMENTS.idle} idle connections; {lost} of {len(times)} not served", said(times),
                "all served")
            row("p99 / p99 without idle ones", f"{spread(times)[1] / spread(alone)[1]:.1f}")
        await ended(tasks)


class Stalled:
    """Connections that take nothing, given up after some time and opened anew, on a thread of their own."""

    def __init__(self, port, words, count, patience=12, each=False):
        """`each`: from an address of its own."""
        self.port, self.count, self.open, self.begun, self.patience, self.each = port, count, True, 0, patience, each
        self.words = words
        self.held = collections.deque()
        self.thread = threading.Thread(target=self.hold)
        self.thread.start()

    def one(self):
        with contextlib.suppress(OSError):
            n = self.begun % self.count
            own = (f"127.1.{n // 250}.{n % 250 + 1}", 0) if self.each else None
            held = socket.create_connection(("127.0.0.1", self.port), 20, own)
            held.sendall(self.words)
            self.held.append((time.monotonic(), held))
            self.begun += 1

    def hold(self):
        while self.open:
            for _ in range(min(100, self.count - len(self.held))):
                self.one()
            while self.held and time.monotonic() - self.held[0][0] > self.patience:
                self.held.popleft()[1].close()
            time.sleep(0.005)
        for _, held in self.held:
            held.close()

    def end(self):
        self.open = False
        self.thread.join()


async def addresses():
    with Museum() as museum:
        tokens = museum.give(50)
        museum.serve()
        alone, _ = await pages_of(museum, tokens, 5, "127.0.0.2")
        others = Stalled(museum.port, b"", ARGUMENTS.addresses, 4, each=True)
        times, lost = await pages_of(museum, tokens, 30, "127.0.0.2")
        row(f"a page beside {ARGUMENTS.addresses} silent connections of as many addresses ({others.begun} in 30 s); "
            f"{lost} of {len(times)} not served", said(times), "worst < 500 ms")
        row("alone", said(alone))
        others.end()


async def stalled():
    with Museum() as museum:
        tokens = museum.give(50)
        museum.serve()
        alone, _ = await pages_of(museum, tokens, 5, "127.0.0.2")
        words = f"GET /k/{tokens[0]}/pot.stl HTTP/1.1\r\nHost: kiosk\r\n\r\n".encode()
        others = Stalled(museum.port, words, ARGUMENTS.stalled)
        times, lost = await pages_of(museum, tokens, 40, "127.0.0.2")
        row(f"a page from another address beside {ARGUMENTS.stalled} downloads that take nothing ({others.begun} in 40 s); "
            f"{lost} of {len(times)} not served", said(times), "worst < 500 ms")
        row("alone", said(alone))
        others.end()


async def phones():
    with Museum() as museum:
        tokens = museum.give(ARGUMENTS.phones * 4)[::4]  # of the visit that has files
        museum.serve()
        for address in ("127.0.1.{}", "127.0.0.1"):
            tasks = await idle(museum.port, ARGUMENTS.idle)
            begun, whole, lost = time.monotonic(), 0, []

            async def phone(n, token):
                nonlocal whole
                rate = Rate(1e6 * ARGUMENTS.rate)

                async def one(name):
                    nonlocal whole
                    target = name if name.startswith("/") else f"/k/{token}" + ("/" + name if name else "")
                    try:
                        status, body = await get(museum.port, target, rate, address=address.format(n + 1))
                        good = status == 200 and (name not in museum.bytes or body == museum.bytes[name])
                    except (OSError, asyncio.IncompleteReadError):
                        good = False
                    whole += good
                    if not good:
                        lost.append(name)
                await asyncio.gather(*(one(name) for name in OF_A_PAGE))
            await asyncio.gather(*(phone(n, token) for n, token in enumerate(tokens)))
            row(f"{ARGUMENTS.phones} phones at {ARGUMENTS.rate} MB/s, {len(OF_A_PAGE)} connections each, from "
                f"{'one address' if address == '127.0.0.1' else 'as many addresses'}, beside {ARGUMENTS.idle} idle ones",
                f"{whole} of {len(tokens) * len(OF_A_PAGE)} whole in {time.monotonic() - begun:.1f} s; not whole: {lost or 'none'}", "all")
            await ended(tasks)


async def slow():
    with Museum() as museum:
        target = f"/k/{museum.give(1)[0]}/pot.stl"
        museum.serve()
        wanted = museum.bytes["pot.stl"]

        async def in_one_go():
            begun = time.monotonic()
            _, body = await get(museum.port, target, Rate(1e6 * ARGUMENTS.slow))
            row(f"pot.stl at {ARGUMENTS.slow} MB/s", f"{'whole' if body == wanted else f'CUT at {body.size}'} after "
                f"{time.monotonic() - begun:.0f} s", "whole")

        async def broken():
            has, tries, rate = Taken(), 0, Rate(1e6)
            while has.size < wanted.size and tries < 100:
                tries += 1
                await get(museum.port, target, rate, f"Range: bytes={has.size}-\r\n", stop=400_000, into=has)
            row("pot.stl over a way that breaks after each 0.4 MB, by Range", f"{'whole' if has == wanted else 'WRONG'} after "
                f"{tries} connections", "whole")

        async def page():
            begun, rate = time.monotonic(), Rate(1e6 * ARGUMENTS.slow)
            of = target.removesuffix("/pot.stl")
            got = [asyncio.create_task(get(museum.port, each if each.startswith("/") else f"{of}/{each}".rstrip("/"), rate))
                   for each in OF_A_PAGE]
            await got[0]
            shown = time.monotonic() - begun
            all_of = [await each for each in got]
            whole = all(status == 200 for status, _ in all_of) and all_of[-1][1] == museum.bytes["pot.glb"]
            row(f"a page's {len(OF_A_PAGE)} files at {ARGUMENTS.slow} MB/s for all of them", f"its words after {shown:.1f} s, "
                f"{'all whole' if whole else 'NOT WHOLE'} after {time.monotonic() - begun:.0f} s", "whole")
        await asyncio.gather(in_one_go(), broken(), page())


async def memory():
    with Museum() as museum:
        target = f"/k/{museum.give(1)[0]}/pot.stl"
        museum.serve()
        before = museum.resident()[0]
        rates = [Rate(3e5) for _ in range(ARGUMENTS.downloads)]
        begun, wanted = time.monotonic(), museum.bytes["pot.stl"]

        async def one(rate):
            try:
                return (await get(museum.port, target, rate))[1] == wanted
            except (OSError, asyncio.IncompleteReadError):
                return False
        whole = sum(await asyncio.gather(*(one(rate) for rate in rates)))
        now, most = museum.resident()
        row(f"{ARGUMENTS.downloads} parallel downloads of pot.stl; {whole} whole in {time.monotonic() - begun:.0f} s",
            f"resident {before / 1e6:.1f} MB before, {most / 1e6:.1f} MB at most, {now / 1e6:.1f} MB after", "< 64 MB")


if __name__ == "__main__":
    PARTS = {"pages": pages, "idle": idle_ones, "addresses": addresses, "stalled": stalled, "phones": phones, "slow": slow, "memory": memory}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="part", help=", ".join(PARTS))
    parser.add_argument("--console", default="build/release/bin/onggi-console")
    parser.add_argument("--passes", type=int, default=10_000)
    parser.add_argument("--idle", type=int, default=1000)
    parser.add_argument("--phones", type=int, default=64)
    parser.add_argument("--rate", type=float, default=1.0)
    parser.add_argument("--downloads", type=int, default=500)
    parser.add_argument("--seconds", type=float, default=70.0)
    parser.add_argument("--stalled", type=int, default=8000)
    parser.add_argument("--addresses", type=int, default=18_000)
    parser.add_argument("--slow", type=float, default=0.1)
    parser.add_argument("--seed", type=int, default=1)
    ARGUMENTS = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_NOFILE, (resource.getrlimit(resource.RLIMIT_NOFILE)[1],) * 2)
    for part in ARGUMENTS.parts or PARTS:
        asyncio.run(PARTS[part]())
