"""The table of the kiosk's rooms in engine/docs/house.md, of tests/house/rooms.txt. house.py calls it."""

import os
import re

DOCUMENT = "engine/docs/house.md"
BEGIN = "<!-- The table is written by tests/house/house.py table, of tests/house/rooms.txt. -->"
END = "<!-- end of the table -->"


def table_lines(root, table):
    """The kiosk's rooms that are built, as a Markdown table; then those that are to come."""
    out, later = ["| room | its job | sees, beside `engine/base` and `engine/math` | libraries |",
                  "|---|---|---|---|"], []
    for room, others in table.rooms.items():
        name = room.partition("kiosk/")[2]
        if not name:
            continue
        if not os.path.isdir(os.path.join(root, room)):
            later.append(f"`{name}`")
            continue
        engine = [o[len("engine/"):] for o in others
                  if o.startswith("engine/") and o not in ("engine/base", "engine/math")]
        kiosk = [o[len("kiosk/"):] for o in others if o.startswith("kiosk/")]
        sees = "; ".join(part for part in (", ".join(kiosk),
                                           "engine: " + ", ".join(engine) if engine else "") if part)
        libraries = dict.fromkeys(re.sub(r"(/\*|\.hp?p?)$", "", h) for h in table.headers[room])
        out.append(f"| {name} | {table.jobs[room]} | {'everyone' if '*' in others else sees} | "
                   f"{', '.join(libraries)} |")
    has = 'has its line' if len(later) == 1 else 'have their lines'
    return out + (["", f"Later: {' and '.join(later)} {has} in the law already."]
                  if later else [])


def split_document(root):
    """The document's lines before the table, in it, and after it."""
    with open(os.path.join(root, DOCUMENT), encoding="utf-8") as file:
        lines = file.read().splitlines()
    if BEGIN not in lines or END not in lines:
        raise SystemExit(f"{DOCUMENT}: the lines '{BEGIN}' and '{END}' are missing.")
    begin, end = lines.index(BEGIN) + 1, lines.index(END)
    return lines[:begin], lines[begin:end], lines[end:]


def write_table(root, table):
    before, _, after = split_document(root)
    with open(os.path.join(root, DOCUMENT), "w", encoding="utf-8") as file:
        file.write("\n".join(before + table_lines(root, table) + after) + "\n")
