#!/usr/bin/env python3
"""Damages every vessel there is and has the finished program look at each: onggi vessel inspect.

  tests/fuzz/vessels.py [--each 40] [--seed 1] [--onggi FILE] [--keep DIR] [--only WORD] [--up]

Takes every file of ../shared/vessels and the exhibit's shelf, and what a .gltf names beside it, and a turned
pot as OBJ, PLY (text and binary) and STL (text and binary), written here. Each is damaged in N ways by seed: bits,
bytes, blocks, ends, numbers and words of JSON. Then one of two things must happen: exit 0 with a report that is
JSON and finite, or exit 2 with one error of where, what and remedy. Never a signal, a hang (60 s of processor time), an escape
code, more than 4 GiB, or anything else on standard error.

--each N   ways a file (default 40)
--keep DIR where what failed is kept, with what was said (default build/vessels.found)
--only W   only files whose path holds W
--up       half of the runs with --up x, -z and so on
exit 0: nothing found, 1: something, 2: it could not be tried
"""

import argparse
import json
import math
import os
import random
import re
import resource
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
ENDINGS = (".glb", ".gltf", ".obj", ".ply", ".stl", ".json")
MOST_MEMORY = 4 << 30
NUMBERS = (b"0", b"-1", b"1e308", b"-1e-320", b"4294967295", b"2147483648", b"18446744073709551615",
           b"5126", b"null", b"[]", b"{}", b'"\\u0000\\u001b[31m"', b"true", b"99999999999999999999999")


def turned_pot():
    """A cup of 48 sectors: corners and triangles, wound outwards."""
    line = [(0.001, 0), (30, 0), (38, 30), (40, 80), (37, 80), (35, 30), (0.001, 6)]
    corners, triangles = [], []
    for i in range(48):
        a = 2 * math.pi * i / 48
        corners += [(r * math.cos(a), h, -r * math.sin(a)) for r, h in line]
    n = len(line)
    for i in range(48):
        for k in range(n - 1):
            a, b = i * n + k, i * n + k + 1
            c, d = (i + 1) % 48 * n + k, (i + 1) % 48 * n + k + 1
            triangles += [(a, c, b), (b, c, d)]
    return corners, triangles


def other_formats():
    """Name and bytes of the pot in each format that the helper reads."""
    corners, triangles = turned_pot()
    words = ["%.4f %.4f %.4f" % c for c in corners]
    obj = "o cup\n" + "".join("v %s\n" % w for w in words)
    obj += "".join("f %d %d %d\n" % tuple(i + 1 for i in t) for t in triangles)
    head = ("ply\nformat %%s 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(corners), len(triangles)))
    text_ply = head % "ascii" + "".join(w + "\n" for w in words) + "".join("3 %d %d %d\n" % t for t in triangles)
    binary_ply = (head % "binary_little_endian").encode()
    binary_ply += b"".join(struct.pack("<3f", *c) for c in corners)
    binary_ply += b"".join(struct.pack("<B3i", 3, *t) for t in triangles)
    text_stl = "solid cup\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %s\n" % words[i] for i in t) + "endloop\nendfacet\n"
        for t in triangles) + "endsolid cup\n"
    binary_stl = b"\0" * 80 + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *corners[t[0]], *corners[t[1]], *corners[t[2]], 0) for t in triangles)
    return {"cup.obj": obj.encode(), "cup_text.ply": text_ply.encode(), "cup.ply": binary_ply,
            "cup_text.stl": text_stl.encode(), "cup.stl": binary_stl}


def damaged(data, rng):
    """`data` after one to four accidents."""
    out = bytearray(data)
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        if not out:
            break
        at = rng.randrange(len(out))
        kind = rng.randrange(10)
        if rng.random() < 0.5:  # where headers and JSON are
            at = rng.randrange(min(len(out), 4096))
        if kind == 0:
            out[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            out[at] = rng.choice((0, 255, 127, 128, rng.randrange(256)))
        elif kind == 2:
            for i in range(at, min(len(out), at + rng.randrange(1, 64))):
                out[i] = rng.randrange(256)
        elif kind == 3:
            del out[at:]
        elif kind == 4:
            del out[at:at + rng.randrange(1, 4096)]
        elif kind == 5:
            out[at:at] = out[rng.randrange(len(out)):][:rng.randrange(1, 2048)]
        elif kind == 6:
            out[at:at + 4] = struct.pack("<I", rng.choice((0, 1, 0x7FFFFFFF, 0xFFFFFFFF, 0x7FC00000, rng.getrandbits(32))))
        else:
            head = bytes(out[:200000])
            if kind == 9:
                found = list(re.finditer(rb'"[A-Za-z_]{2,}"', head))
                if len(found) > 1:
                    here, other = rng.choice(found), rng.choice(found)
                    out[here.start():here.end()] = head[other.start():other.end()]
            else:
                found = list(re.finditer(rb"-?\d+(\.\d+)?([eE][-+]?\d+)?", head))
                if found:
                    here = rng.choice(found)
                    out[here.start():here.end()] = rng.choice(NUMBERS)
    return bytes(out)


def targets(only):
    """(folder to copy or None, file to inspect, file to damage, its bytes if written here)."""
    out = []
    for top in ("../shared/vessels", "content/vessels"):
        for folder, _, names in sorted(os.walk(os.path.join(ROOT, top))):
            for name in sorted(names):
                path = os.path.join(folder, name)
                ending = os.path.splitext(name)[1].lower()
                if ending in ENDINGS and ending != ".json" or name in ("manifest.json", "document.json"):
                    out.append((folder if ending in (".gltf", ".json") else None, path, path, None))
                if ending == ".gltf":
                    with open(path, encoding="utf-8") as file:
                        named = json.load(file)
                    for entry in named.get("buffers", []) + named.get("images", []):
                        uri = entry.get("uri", "data:")
                        if not uri.startswith("data:") and os.path.isfile(os.path.join(folder, uri)):
                            out.append((folder, path, os.path.join(folder, uri), None))
    out += [(None, name, name, data) for name, data in other_formats().items()]
    return [t for t in out if only in t[2]]


def confined():
    """Processor time, not the wall's: beside other work a run that waits looks like one that hangs."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (60, 60))


def wrong_with(run, report):
    """What is wrong with how a run ended, or None."""
    said = run.stderr.decode("utf-8", "replace")
    if any(ord(c) < 32 and c not in "\n\t" or ord(c) == 127 for c in said + run.stdout.decode("utf-8", "replace")):
        return "a control character is printed"
    if run.returncode == 0:
        if said.strip():
            return "exit 0, and something on standard error"
        try:
            with open(report, encoding="utf-8") as file:
                found = json.load(file, parse_constant=lambda word: 1 / 0)
        except (OSError, ValueError, ZeroDivisionError) as error:
            return "exit 0, and the report is no JSON: %s" % error
        numbers = [found["height_m"], found["up_sure"]] + [x for p in found["outer"] for x in p]
        if not all(math.isfinite(x) for x in numbers) or not 0.004 <= found["height_m"] <= 2.0:
            return "exit 0, and a figure that no vessel has"
        return None
    if run.returncode != 2:
        return "exit %d" % run.returncode
    lines = said.rstrip("\n").split("\n")
    if len(lines) < 2 or ": " not in lines[0] or lines[0].startswith(" ") or not lines[-1].startswith("  "):
        return "exit 2 without place, meaning and remedy"
    if sum(not line.startswith(" ") for line in lines) != 1:
        return "more than one error"
    return None


def main():
    wanted = argparse.ArgumentParser(add_help=False)
    wanted.add_argument("--each", type=int, default=40)
    wanted.add_argument("--seed", type=int, default=1)
    wanted.add_argument("--onggi", default=os.path.join(ROOT, "build", "release", "bin", "onggi"))
    wanted.add_argument("--keep", default=os.path.join(ROOT, "build", "vessels.found"))
    wanted.add_argument("--only", default="")
    wanted.add_argument("--up", action="store_true")
    wanted.add_argument("--help", "-h", action="store_true")
    a = wanted.parse_args()
    if a.help:
        print(__doc__)
        return 0
    if not os.access(a.onggi, os.X_OK):
        print("%s is not there: build it first." % a.onggi)
        return 2
    tries = refused = failed = 0
    slowest = (0.0, "")
    with tempfile.TemporaryDirectory() as work:
        for folder, inspected, hurt, data in targets(a.only):
            name = os.path.relpath(hurt, ROOT) if data is None else hurt
            if data is None:
                with open(hurt, "rb") as file:
                    data = file.read()
            before = (tries, refused, failed)
            for way in range(a.each):
                rng = random.Random("%s/%d/%d" % (name, a.seed, way))
                place = os.path.join(work, "pack")
                shutil.rmtree(place, ignore_errors=True)
                if folder:
                    shutil.copytree(folder, place)
                    for here, _, names in os.walk(place):
                        for one in [here] + [os.path.join(here, n) for n in names]:
                            os.chmod(one, 0o755)
                    file = os.path.join(place, os.path.relpath(hurt, folder))
                    look = os.path.join(place, os.path.relpath(inspected, folder))
                else:
                    os.mkdir(place)
                    file = look = os.path.join(place, os.path.basename(hurt))
                with open(file, "wb") as out:
                    out.write(damaged(data, rng))
                report = os.path.join(work, "report.json")
                if os.path.exists(report):
                    os.unlink(report)
                words = [a.onggi, "vessel", "inspect", look, "--json", report]
                if a.up and way % 2:
                    words += ["--up=" + rng.choice(("x", "y", "z", "-x", "-y", "-z"))]
                began = resource.getrusage(resource.RUSAGE_CHILDREN)
                try:
                    run = subprocess.run(words, capture_output=True, timeout=900, check=False, preexec_fn=confined)
                    wrong, said = wrong_with(run, report), run.stderr
                    refused += run.returncode == 2
                except subprocess.TimeoutExpired:
                    wrong, said = "it hangs", b""
                now = resource.getrusage(resource.RUSAGE_CHILDREN)
                took = now.ru_utime + now.ru_stime - began.ru_utime - began.ru_stime
                slowest = max(slowest, (took, "%s way %d" % (name, way)))
                tries += 1
                if wrong:
                    failed += 1
                    kept = os.path.join(a.keep, "%s.%d.%d" % (name.replace("/", "_"), a.seed, way))
                    shutil.rmtree(kept, ignore_errors=True)
                    shutil.copytree(place, kept)
                    print("%s, way %d: %s: %s" % (name, way, wrong, said[:300].decode("utf-8", "replace")), flush=True)
            print("%s: %d looks, %d refused, %d wrong" % (
                name, tries - before[0], refused - before[1], failed - before[2]), flush=True)
    print("%d looks, %d refused, %d wrong; the slowest took %.1f s of the processor (%s)." % (tries, refused, failed, *slowest))
    return 1 if failed else 0 if tries else 2


if __name__ == "__main__":
    sys.exit(main())
