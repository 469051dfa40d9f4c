"""Constants of a room's sources whose names meet when they are compiled together (ONGGI_UNITY).

Which sources are compiled together changes with their number, so two that clash may meet on any day. house.py calls
check(). Tests name their lumps and hands alike, so each is in a namespace of its file's name.
"""

import collections
import os
import re

# What ticks is compiled file by file (CMakeLists.txt).
ALONE = {"engine/math", "engine/clay", "engine/contact", "engine/effects", "engine/force", "engine/scene"}
CONSTANT = re.compile(r"(\s*)(?:inline |static )*(?:constexpr|const)\s[^;]*")
NAME = re.compile(r"\b(k[A-Z]\w*)\s*(?:\[[^\]]*\])?\s*[={](?!=)")


def check(names, read, room_of):
    """What is wrong, and what was looked at. `read(name)` gives a file's lines."""
    broken, looked_at = [], 0
    rooms = collections.defaultdict(list)
    for name in names:
        if name.endswith(".cpp") and name.startswith(("engine/", "kiosk/")):
            rooms[room_of(name)].append(name)
    for room, files in rooms.items():
        if room in ALONE:
            continue
        own, inner = collections.defaultdict(list), collections.defaultdict(list)
        for name in sorted(files):
            for number, line in enumerate(read(name), 1):
                found = CONSTANT.match(line)
                for constant in NAME.findall(found.group(0)) if found else []:
                    looked_at += 1
                    (inner if found.group(1) else own)[constant].append((name, number))
        for constant, places in own.items():
            other = next((p for p in places + inner.get(constant, []) if p[0] != places[0][0]), None)
            if other:
                broken.append(f"{other[0]}:{other[1]}: {constant} is in {places[0][0]}:{places[0][1]} too, and both may be "
                              "compiled together. Call one otherwise")
    tests = [n for n in names if n.startswith(("tests/engine/", "tests/kiosk/")) and n.endswith("_test.cpp")]
    for name in tests:
        own = os.path.basename(name)[:-len(".cpp")]
        if not any(re.fullmatch(rf"namespace onggi(::\w+)*::{own} {{", line) for line in read(name)):
            broken.append(f"{name}: compiled with other tests, and not in a namespace of its own. "
                          f"Write namespace onggi::{own} {{")
    return broken, (f"{looked_at} constants have a name of their own in their room's sources, and {len(tests)} files of "
                    "tests a namespace")
