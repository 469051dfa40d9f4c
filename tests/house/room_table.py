"""The table of wings in engine/docs/house.md and the picture beside it, both drawn from tests/house/rooms.txt. house.py calls it."""

import os
import re

DOCUMENT = "engine/docs/house.md"
PICTURE = "engine/docs/figures/house.svg"
BEGIN = "<!-- The table is written by tests/house/house.py table, of tests/house/rooms.txt. -->"
END = "<!-- end of the table -->"
WIDTH, HEIGHT, GAP, FLOOR = 230, 54, 26, 110  # of a box, between two, and from floor to floor; px


def wings(table):
    """{wing: the wings that it sees}, of the kiosk."""
    return {name: [other for other in seen if other.startswith("kiosk/")]
            for name, seen in table.sees.items() if name.startswith("kiosk/")}


def rooms_in(root, wing):
    """A wing's rooms that are built, as they stand in its folder."""
    folder = os.path.join(root, wing)
    return sorted(n for n in os.listdir(folder) if os.path.isdir(os.path.join(folder, n))) if os.path.isdir(folder) else []


def table_lines(root, table):
    """The kiosk's wings that are built, as a Markdown table."""
    out = ["| wing | its job | its rooms | sees | libraries |", "|---|---|---|---|---|"]
    for wing, others in wings(table).items():
        rooms = rooms_in(root, wing)
        if not rooms:
            continue
        libraries = dict.fromkeys(re.sub(r"(/\*|\.hp?p?)$", "", header)
                                  for headers, targets, places in table.libraries for header in headers
                                  if targets != ["Threads::Threads"] and any(p.startswith(wing + "/") for p in places))
        sees = ", ".join(o[len("kiosk/"):] for o in others) or "the engine alone"
        out.append(f"| [{wing[len('kiosk/'):]}](../../{wing}/README.md) | {table.jobs[wing]} | {', '.join(rooms)} | "
                   f"{sees} | {', '.join(libraries)} |")
    return out


def floors(sees):
    """{wing: how high it stands}: one floor above the highest that it sees."""
    def floor(wing):
        return 1 + max((floor(other) for other in sees[wing]), default=-1)
    return {wing: floor(wing) for wing in sees}


def drawn(sees):
    """What an arrow is drawn for: what a wing sees beside what it sees through another."""
    def through(wing):
        return {o for other in sees[wing] for o in {other} | through(other)}
    return {wing: [o for o in others if not any(o in through(other) for other in others)]
            for wing, others in sees.items()}


def picture(root, table):
    """The kiosk's wings by floors, as an SVG: an arrow goes down to what a wing sees."""
    built = {wing: others for wing, others in wings(table).items() if rooms_in(root, wing)}
    sees = {wing: [other for other in others if other in built] for wing, others in built.items()}
    at, height = {}, floors(sees)
    most = max((list(height.values()).count(f) for f in height.values()), default=1)
    width, top = most * (WIDTH + GAP) + GAP, max(height.values(), default=0)
    for floor in range(top + 1):
        row = [wing for wing in sees if height[wing] == floor]
        left = (width - len(row) * (WIDTH + GAP) + GAP) / 2
        for n, wing in enumerate(row):
            at[wing] = (left + n * (WIDTH + GAP), GAP + (top - floor) * FLOOR)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{2 * GAP + top * FLOOR + HEIGHT}" '
           'font-family="sans-serif">',
           '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           '<path d="M0 0 L8 4 L0 8 z" fill="#7a6a5a"/></marker></defs>',
           '<rect width="100%" height="100%" fill="#fbf8f3"/>']
    for wing, others in drawn(sees).items():
        for other in others:
            (x, y), (to_x, to_y) = at[wing], at[other]
            out.append(f'<path d="M{x + WIDTH / 2:g} {y + HEIGHT} L{to_x + WIDTH / 2:g} {to_y - 2}" stroke="#7a6a5a" '
                       'stroke-width="1.5" fill="none" marker-end="url(#tip)"/>')
    for wing, (x, y) in at.items():
        rooms = " ".join(rooms_in(root, wing))
        out += [f'<rect x="{x:g}" y="{y}" width="{WIDTH}" height="{HEIGHT}" rx="6" fill="#efe3d2" stroke="#7a6a5a"/>',
                f'<text x="{x + WIDTH / 2:g}" y="{y + 23}" text-anchor="middle" font-size="17" fill="#2b211a">'
                f'{wing[len("kiosk/"):]}</text>',
                f'<text x="{x + WIDTH / 2:g}" y="{y + 42}" text-anchor="middle" font-size="11.5" fill="#5c4c3f">{rooms}</text>']
    return "\n".join(out + ["</svg>"]) + "\n"


def split_document(root):
    """The document's lines before the table, in it, and after it."""
    with open(os.path.join(root, DOCUMENT), encoding="utf-8") as file:
        lines = file.read().splitlines()
    if BEGIN not in lines or END not in lines:
        raise SystemExit(f"{DOCUMENT}: the lines '{BEGIN}' and '{END}' are missing.")
    begin, end = lines.index(BEGIN) + 1, lines.index(END)
    return lines[:begin], lines[begin:end], lines[end:]


def stale(root, table):
    """What is not as rooms.txt has it."""
    remedy = "it is not as tests/house/rooms.txt has it. Run tests/house/house.py table"
    out = []
    if split_document(root)[1] != table_lines(root, table):
        out.append(f"{DOCUMENT}, the table: {remedy}")
    path = os.path.join(root, PICTURE)
    text = None
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            text = file.read()
    if text != picture(root, table):
        out.append(f"{PICTURE}: {remedy}")
    return out


def write_table(root, table):
    before, _, after = split_document(root)
    with open(os.path.join(root, DOCUMENT), "w", encoding="utf-8") as file:
        file.write("\n".join(before + table_lines(root, table) + after) + "\n")
    os.makedirs(os.path.dirname(os.path.join(root, PICTURE)), exist_ok=True)
    with open(os.path.join(root, PICTURE), "w", encoding="utf-8") as file:
        file.write(picture(root, table))
