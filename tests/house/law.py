"""The law of the house: tests/house/rooms.txt, read. house.py holds the sources to it."""

import fnmatch
import re


def within(path, place):
    """True where `path` is `place`, or lies in it."""
    return path == place or path.startswith(place + "/")


class Table:
    """rooms.txt: what each room and wing sees, and whose each library is."""

    def __init__(self, path):
        self.sees, self.jobs, self.libraries, self.system, self.never = {}, {}, [], {}, {}
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                line, _, job = (part.strip() for part in line.partition("#"))
                if not line:
                    continue
                name, *columns = re.split(r"\s+:(?:\s+|$)", line)
                columns = [column.split() for column in columns]
                kind, *names = name.split()
                if not columns or (kind == "library") != (len(columns) == 2):
                    raise SystemExit(f"{path}:{number}: expected 'room : rooms  # job' or "
                                     "'library HEADERS : targets : rooms'")
                if kind == "library":
                    self.libraries.append((names, *columns))
                elif kind in ("system", "never"):
                    getattr(self, kind)[names[0]] = columns[0]
                else:
                    self.sees[name], self.jobs[name] = columns[0], job

    def row(self, room):
        """The line that speaks of `room`: its own, or its wing's. None where there is none."""
        return next((name for name in self.sees if room and within(room, name)), None)

    def may_see(self, room, other):
        """True where `room` may include or link the room `other`."""
        row = self.row(room)
        seen = [*self.sees[row], row]
        return "*" in seen or (other is not None and any(within(other, place) for place in seen))

    def headers(self, room):
        """Patterns of the third-party headers that are this room's."""
        return [header for headers, _, rooms in self.libraries for header in headers
                if any(within(room, place) for place in rooms)]

    def owners(self, column, wanted):
        """Whose a header (column 0) or a CMake target (column 1) is."""
        return [place for library in self.libraries if place_of(wanted, library[column]) for place in library[2]]

    def cycles(self):
        """Rooms and wings that reach themselves through the table: there must be none."""
        return circles({row: {other for name in seen for other in self.sees if name != "*" and within(other, name)}
                        for row, seen in self.sees.items()})


def place_of(wanted, patterns):
    return any(fnmatch.fnmatchcase(wanted, pattern) for pattern in patterns)


def circles(edges):
    """The nodes of {node: nodes} that reach themselves."""
    def reaches(start, node, seen):
        for other in edges.get(node, ()):
            if other == start:
                return True
            if other not in seen:
                seen.add(other)
                if reaches(start, other, seen):
                    return True
        return False
    return [node for node in edges if reaches(node, node, set())]


def room_of(path):
    """engine/clay/clay.h -> engine/clay; kiosk/wheel/loop/pacer.h -> kiosk/wheel/loop; tests/... -> tests; else None."""
    parts = path.split("/")
    if parts[0] == "tests":
        return "tests"
    depth = {"engine": 2, "kiosk": 3}.get(parts[0], len(parts))
    return "/".join(parts[:depth]) if len(parts) > depth and parts[1] != "docs" else None
