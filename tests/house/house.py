#!/usr/bin/env python3
"""The house rules of engine/docs/house.md, checked. Prints where, what is wrong and what to do.

  tests/house/house.py includes|links|length|headers|layout|names|unity|docs|format [--root DIR]
  tests/house/house.py table    writes the table of rooms into engine/docs/house.md
  exit 0: kept, 1: broken, 77: cannot be checked here (says why)
"""

import argparse
import fnmatch
import os
import re
import shutil
import subprocess
import sys

import page_truth
import public_names
import room_table
import unity_names
from law import Table, circles, place_of, room_of, within

LONG_LINES = 400  # a warning
MAX_LINES = 600
CPP = (".h", ".cpp")
SOURCES = CPP + (".glsl", ".vert", ".frag", ".py", ".sh", ".cmake")
TOP = set("""CMakeLists.txt kiosk engine content config tests README.md CHANGELOG.md LICENSE
CMakePresets.json CONTRIBUTING.md .clang-format .clang-tidy .editorconfig .gitignore .ci""".split())
HALF_FILES = {
    "engine": {"CMakeLists.txt"},
    "kiosk": {"CMakeLists.txt", "libraries.cmake", "start", "install-packages", "packages.txt"},
}
GLOBAL_FLAGS = re.compile(r"CMAKE_CXX_FLAGS\w*|\badd_(?:compile|link)_options\b|-ffast-math|-Ofast")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:<([^>]+)>|"([^"]+)")')


def files_of(root):
    """The project's files: what git tracks or would track, or everything where there is no git."""
    if os.path.exists(os.path.join(root, ".git")) and shutil.which("git"):
        listing = subprocess.run(
            ["git", "-c", "safe.directory=*", "ls-files", "-z", "--cached", "--others",
             "--exclude-standard"], cwd=root, capture_output=True, check=True)
        names = listing.stdout.decode().split("\0")
        return sorted(n for n in set(names) if n and os.path.exists(os.path.join(root, n)))
    found = []
    for folder, folders, names in os.walk(root):
        if folder == root:
            folders[:] = [f for f in folders if not f.startswith("build") and f != "keepsakes"]
        found += [os.path.relpath(os.path.join(folder, n), root) for n in names]
    return sorted(found)


def read_lines(root, name):
    with open(os.path.join(root, name), encoding="utf-8", errors="replace") as file:
        return file.read().splitlines()


def seen_by(table, room):
    return " ".join(table.sees[table.row(room)]) or "no other room"


def check_includes(root, table):
    """Rules 1 and 3: include lines start at the root, name only rooms and libraries of the table."""
    broken, count, inside = [], 0, {}
    for name in files_of(root):
        room = room_of(name)
        if room is None or not name.endswith(CPP):
            continue
        count += 1
        half = room.split("/")[0]
        if table.row(room) is None:
            broken.append(f"{name}: {room} is not in tests/house/rooms.txt, nor is its wing. Add it there.")
            continue
        libraries = table.headers(room)
        if half == "tests":
            mirrored = room_of(name.split("/", 1)[1])  # a room's tests may use that room's library
            libraries += table.headers(mirrored) if mirrored else []
        for number, line in enumerate(read_lines(root, name), 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            system, own = found.groups()
            where = f"{name}:{number}: "
            if own is not None:
                allowed_roots = ("engine/", "kiosk/") + (("tests/",) if half == "tests" else ())
                if not own.startswith(allowed_roots):
                    broken.append(f'{where}"{own}" does not start at the repository root. '
                                  f'Write "{os.path.dirname(name)}/{own}", or <> for a library.')
                elif not table.may_see(room, room_of(own)):
                    broken.append(f"{where}{room} may not include {own}. It sees: {seen_by(table, room)}.")
                elif within(room, table.row(room)) and table.row(room_of(own) or "") == table.row(room) != "tests":
                    inside.setdefault(room, {}).setdefault(room_of(own), where)
            elif system.startswith(("engine/", "kiosk/")):
                broken.append(f'{where}write "{system}" in quotes: it is our own.')
            elif place_of(system, table.never.get(half, [])):
                broken.append(f"{where}the {half} never includes <{system}>: it is numbers in, "
                              "numbers out. Take the value as an argument.")
            elif "." not in system and "/" not in system:
                pass  # the C++ standard library
            elif not place_of(system, libraries + table.system.get(half, [])):
                owners = table.owners(0, system)
                remedy = (f"It belongs to {' and '.join(owners)}: go through that room."
                          if owners else "Give it one room in tests/house/rooms.txt.")
                broken.append(f"{where}{room} may not include <{system}>. {remedy}")
    for room in circles({room: {o for o in others if o != room} for room, others in inside.items()}):
        other, where = next((o, w) for o, w in inside[room].items() if o != room)
        broken.append(f"{where}{room} and {other} go round in a circle. In a wing, too, lower never includes higher.")
    return broken, f"{count} files keep the include table"


def cmake_calls(text):
    """Yields (function, words) for every call in a CMake file without nested calls."""
    text = re.sub(r"#.*", "", text)
    for found in re.finditer(r"(\w+)\s*\(([^()]*)\)", text):
        yield found.group(1), found.group(2).split()


def sections(words, keywords):
    parts, current = {"": []}, ""
    for word in words:
        if word in keywords:
            current = word
            parts.setdefault(current, [])
        else:
            parts[current].append(word)
    return parts


def check_links(root, table):
    """Rules 1 and 3 for what CMake links."""
    broken, count = [], 0
    for room in table.cycles():
        broken.append(f"tests/house/rooms.txt: {room} reaches itself. Lower never includes higher.")
    for name in files_of(root):
        room = room_of(name)
        if os.path.basename(name) not in ("CMakeLists.txt", "CMakePresets.json"):
            continue
        for number, line in enumerate(read_lines(root, name), 1):
            found = GLOBAL_FLAGS.search(line.split("#")[0])
            if found:
                broken.append(f"{name}:{number}: no global flags, never fast-math: put "
                              f"{found.group(0)}'s work on the target onggi_build.")
        if room in (None, "tests"):
            continue
        if table.row(room) is None:
            broken.append(f"{name}: {room} is not in tests/house/rooms.txt, nor is its wing. Add it there.")
            continue
        for function, words in cmake_calls("\n".join(read_lines(root, name))):
            if function == "target_link_libraries":
                broken.append(f"{name}: link through onggi_room or onggi_program (ROOMS, LIBS), "
                              "so that the table can be checked.")
            if function not in ("onggi_room", "onggi_program"):
                continue
            count += 1
            parts = sections(words, ("ROOMS", "LIBS", "PUBLIC_LIBS", "FOLDERS", "EXCLUDE", "BRIEF"))
            if function == "onggi_room" and parts[""] != [room]:
                broken.append(f"{name}: onggi_room({' '.join(parts[''])}) should name {room}.")
            for other in parts.get("ROOMS", []):
                if not table.may_see(room, other):
                    broken.append(f"{name}: {room} may not link {other}. It sees: {seen_by(table, room)}.")
            for library in parts.get("LIBS", []) + parts.get("PUBLIC_LIBS", []):
                plain = re.sub(r"\$<TARGET_NAME_IF_EXISTS:([^>]*)>", r"\1", library)
                owners = table.owners(1, plain)
                if not any(within(room, owner) for owner in owners):
                    remedy = (f"It belongs to {' and '.join(owners)}." if owners
                              else "Give it one room in tests/house/rooms.txt.")
                    broken.append(f"{name}: {room} may not link {plain}. {remedy}")
    return broken, f"{count} libraries and programs keep the link table"


def exceptions(root, listing, may):
    """{name: line number} of a list of 'name : reason', and what is wrong with it."""
    broken, excepted = [], {}
    for number, line in enumerate(read_lines(root, listing), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        name, _, reason = (part.strip() for part in line.partition(" : "))
        if not reason:
            broken.append(f"{listing}:{number}: say why {name} may {may}: 'name : reason'.")
        excepted[name] = number
    return broken, excepted


def check_length(root, _table):
    """Rule 4: a source over 600 lines fails, unless it is in the list with a reason; one over 400 is warned of."""
    count, long = 0, []
    listing = "tests/house/long_files.txt"
    broken, excepted = exceptions(root, listing, "be long")
    for name in files_of(root):
        if not name.endswith(SOURCES) or name.split("/")[0] not in ("engine", "kiosk", "tests"):
            continue
        count += 1
        length = len(read_lines(root, name))
        if LONG_LINES < length <= MAX_LINES:
            long.append(f"{name} ({length})")
        if length > MAX_LINES and name not in excepted:
            broken.append(f"{name}: {length} lines, {MAX_LINES} is the most. Split it by job: "
                          "one clear job a file.")
        if name in excepted and length <= MAX_LINES:
            broken.append(f"{listing}:{excepted[name]}: {name} is short again. Remove the line.")
    for path, number in excepted.items():
        if not os.path.exists(os.path.join(root, path)):
            broken.append(f"{listing}:{number}: {path} is gone. Remove the line.")
    return broken, f"{count} sources, none over {MAX_LINES} lines" + (
        f" but {len(excepted)} by name" if excepted else "") + (
        f". Warning: more than {LONG_LINES} lines: {', '.join(long)}" if long else "")


def check_headers(root, _table):
    """Rule 5: every source has a header of its own name beside it, and no two headers share one."""
    listing = "tests/house/headers.txt"
    broken, excepted = exceptions(root, listing, "be so")
    names, used = files_of(root), set()

    def is_excepted(name):
        found = [pattern for pattern in excepted if fnmatch.fnmatchcase(name, pattern)]
        used.update(found)
        return bool(found)

    sources = [n for n in names if n.endswith(".cpp") and room_of(n) not in (None, "tests")]
    for name in sources:
        if name[:-len("cpp")] + "h" not in names and not is_excepted(name):
            broken.append(f"{name}: it has no header of its own. Put what others call into "
                          f"{name[:-len('cpp')]}h, or name it in {listing} with the reason.")
    headers = {}
    for name in names:
        if name.endswith(".h"):
            headers.setdefault(os.path.basename(name), []).append(name)
    for base, paths in sorted(headers.items()):
        if len(paths) > 1 and not is_excepted(base):
            broken.append(f"{' and '.join(paths)} share a name. Name each for what it alone holds.")
    for pattern, number in excepted.items():
        if pattern not in used:
            broken.append(f"{listing}:{number}: {pattern} needs no exception any more. "
                          "Remove the line.")
    return broken, (f"{len(sources)} sources have a header of their own but by name, "
                    f"{len(headers)} headers a name of their own")


def check_layout(root, table):
    """The top level is fixed; below engine/ and kiosk/ are rooms and docs; tests mirror them."""
    broken, names = [], files_of(root)
    for top in sorted({name.split("/")[0] for name in names} - TOP):
        broken.append(f"{top}: the top level is fixed. Put it in the room whose job it does.")
    for name in names:
        parts = name.split("/")
        if parts[0] in HALF_FILES:
            if len(parts) == 2 and parts[1] not in HALF_FILES[parts[0]]:
                broken.append(f"{name}: belongs in a room of {parts[0]}/, or in {parts[0]}/docs.")
            elif len(parts) > 2 and parts[1] != "docs" and table.row("/".join(parts[:2])) is None:
                broken.append(f"{name}: {parts[0]}/{parts[1]} is not in tests/house/rooms.txt.")
            elif parts[0] == "kiosk" and len(parts) == 3 and parts[1] != "docs" and parts[2] != "README.md":
                broken.append(f"{name}: belongs in a room of {parts[0]}/{parts[1]}/.")
        if name.endswith("_test.cpp") and parts[0] == "tests":
            mirrored = room_of("/".join(parts[1:]))
            own = "/".join(parts[:-1][:3 if parts[1] == "engine" else 4]) + "/CMakeLists.txt"  # of many rooms: says which itself
            if (mirrored is None or table.row(mirrored) is None) and own not in names:
                broken.append(f"{name}: no program runs it. Tests lie where their room lies: "
                              "tests/engine/clay/clay_test.cpp.")
            if re.search(r"\bTempDir\(\)|\btemp_directory_path\(\)", "\n".join(read_lines(root, name))):
                broken.append(f"{name}: tests run beside each other, and two of them may name one file. "
                              "Write into a ScratchFolder (tests/kiosk/ground/files).")
    return broken, f"{len(names)} files lie where the house has a place for them"


def check_docs(root, table):
    """The pages are true (page_truth.py), and the table of rooms is that of rooms.txt, with every job."""
    def read(name):
        return "\n".join(read_lines(root, name)) if os.path.isfile(os.path.join(root, name)) else None

    broken, kept = page_truth.check(files_of(root), read)
    broken += [f"tests/house/rooms.txt: say the job of {room} behind a # at the end of its line."
              for room, job in table.jobs.items() if room != "tests" and not job]
    broken += room_table.stale(root, table)
    return broken, kept + "; the table of rooms is that of rooms.txt"


def check_names(root, _table):
    """What engine headers declare in onggi:: itself is listed: a new public name is a decision."""
    return public_names.check(files_of(root), lambda name: "\n".join(read_lines(root, name)), room_of)


def check_unity(root, _table):
    """Constants of sources that may be compiled together have names of their own."""
    return unity_names.check(files_of(root), lambda name: read_lines(root, name), room_of)


def check_format(root, _table):
    """clang-format 14, as .clang-format says."""
    tool = next((t for t in ("clang-format-14", "clang-format") if shutil.which(t)), None)
    version = subprocess.run([tool, "--version"], capture_output=True, text=True).stdout if tool else ""
    if "version 14" not in version:
        print("format: not checked, clang-format 14 is not here: Debian 12 has it.")
        sys.exit(77)
    names = [n for n in files_of(root)
             if n.endswith(CPP) and n.split("/")[0] in ("engine", "kiosk", "tests")]
    broken = []
    for start in range(0, len(names), 50):
        run = subprocess.run([tool, "--dry-run", "-Werror", *names[start:start + 50]],
                             cwd=root, capture_output=True, text=True)
        at = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", run.stderr, re.M)))
        broken += [f"{name}: not formatted. Run {tool} -i {name}" for name in at]
        if run.returncode and not at:
            broken.append(run.stderr.strip())
    return broken, f"{len(names)} files are formatted"


CHECKS = {"includes": check_includes, "links": check_links, "length": check_length,
          "headers": check_headers, "layout": check_layout, "names": check_names,
          "unity": check_unity, "docs": check_docs, "format": check_format}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("check", choices=[*CHECKS, "all", "table"])
    parser.add_argument("--root", default=os.path.join(os.path.dirname(__file__), "..", ".."))
    arguments = parser.parse_args()
    root = os.path.realpath(arguments.root)
    table = Table(os.path.join(root, "tests/house/rooms.txt"))
    if arguments.check == "table":
        room_table.write_table(root, table)
        return
    failed = False
    for check in CHECKS if arguments.check == "all" else [arguments.check]:
        broken, kept = CHECKS[check](root, table)
        print("\n".join(broken) if broken else f"{check}: {kept}.")
        failed = failed or bool(broken)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
