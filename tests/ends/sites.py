"""Exhibits whose values stand at the ends of what `onggi check` accepts: which there are, and their files."""
import itertools
import json
import math
import os
import random
import re
import shutil
import subprocess

import scan

WORD = 40  # letters of the longest word (kiosk/collection/settings/visitor_text.h)
ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
with open(os.path.join(ROOT, "engine/effects/effect_list.h"), encoding="utf-8") as listed:
    EFFECTS = tuple(re.findall(r"visit\(def\.(\w+)\)", listed.read()))
# Elements at the bound of a scene's grid (kiosk/collection/settings/scene_file.cpp), and its least.
GRIDS = ((8, 16), (8, 8192), (20000, 16), (20000, 209), (512, 8192), (2048, 2048))
# Rows and sectors of a scan's triangles, pixels of its picture's side: one that a museum has, and one of millions.
SCANS = ((400, 400, 4096), (1001, 1000, 8192))
MISSIONS = ("today", "describe", "eyes_closed", "two_hands")

# Tools of a way of decorating (kiosk/collection/decoration/way.cpp): law, how it is led, what else it says, and its keys' least, usual
# and greatest. A way has six at the most, so there are two.
WAYS = (
    (("brush", "line", 'with = ["white", "black"]', {"width_mm": (0.5, 6, 40), "thickness_um": (2, 150, 2000), "fill": (0, 0.67, 1)}),
     ("brush", "figure", 'with = ["black"]', {"width_mm": (0.5, 2, 40), "size_mm": (5, 30, 100)}),
     ("cut", "ring", 'section = "v"', {"width_mm": (0.2, 2, 10), "depth_mm": (0.15, 0.5, 3)}),
     ("dip", "all", "", {"thickness_um": (10, 500, 1000)}),
     ("wipe", "line", "", {"width_mm": (2, 12, 30)}),
     ("smoke", "up", "", {})),
    (("dip", "up", 'with = ["white"]', {"thickness_um": (10, 500, 1000)}),
     ("cut", "figure", 'section = "flat"', {"width_mm": (0.2, 2, 10), "depth_mm": (0.15, 0.5, 3), "size_mm": (5, 30, 100)}),
     ("cut", "line", 'section = "u"', {"width_mm": (0.2, 2, 10), "depth_mm": (0.15, 0.5, 3)}),
     ("brush", "all", 'with = ["black"]', {"width_mm": (0.5, 6, 40), "thickness_um": (2, 150, 2000), "fill": (0, 0.67, 1)}),
     ("scrape", "all", "", {"width_mm": (1, 20, 40)}),
     ("burnish", "ring", "", {"width_mm": (1, 6, 20)})))

# Letters that are wide, tall, marked, joined, or each a word: (language, one word or more).
WRITINGS = {
    "wide": ("en", "W" * WORD + " "),
    "hangul": ("ko", "뷁쀍뙗뛟"),
    "arabic": ("ar", "شَّمْسٌضَّخْمَةٌلَّاً "),
    "stacked": ("en", ("x" + "\u0301\u0323\u0308\u0330" * 9 + " ")),
    "indic": ("en", "क्ष्म्यर्त्स्न्यङ्क्ष्व "),
    "emoji": ("en", "👩🏽‍🚒👨‍👩‍👧‍👦🏳️‍🌈🇰🇷"),
    "han": ("ja", "龘靐齉爩"),
    "short": ("en", "i "),
    "mixed": ("en", "aب가ไ👍 "),
    # Six letters each of ten writings whose fonts nothing else asks for.
    "rare": ("en", "".join("".join(chr(first + n) for n in range(6)) + " " for first in (
        0x10500, 0x10530, 0x102A0, 0x10840, 0x11180, 0x16A40, 0x1E900, 0x10A60, 0x12000, 0x1E800))),
    # Letters that no font has, each another one: of writings that are seldom drawn, and of the planes for private use.
    "unwritten": ("en", "".join("a" + "".join(chr(first + n) for n in range(6)) + " " for first in (
        0x11EE0, 0x10FB0, 0x16AC0, 0x11F00, 0x1E4D0, 0xF0000, 0xF1234, 0xFABCD, 0x100000, 0x10F0F0))),
}


def text_of(bound, writing):
    """As many letters as a text of this bound may have."""
    if writing == "lines":
        words = "a\n" if bound["lines"] else "a "
    else:
        words = WRITINGS[writing][1]
    text = ""
    for letter in itertools.cycle(words):
        wide = 2 if bound["wide"] and 0x1100 <= ord(letter) and not 0x200B <= ord(letter) <= 0x2010 else 1
        if count(text, bound) + wide > bound["letters"]:
            break
        text += letter
    return text.rstrip() or "x"


def count(text, bound):
    return sum(2 if bound["wide"] and ord(c) >= 0x1100 and not 0x200B <= ord(c) <= 0x2010 else 1 for c in text)


class Case:
    """`edits`: {(file, table, key): value as TOML writes it}."""

    def __init__(self, name, edits=None, language="en", mission=None, shelf=2, drawn=False, words=False, paper=False, scanned=None,
                 way=(0, 1)):
        self.name, self.edits, self.language, self.shelf = name, dict(edits or {}), language, shelf
        self.kind, self.mission = mission, -1 if mission is None else 0
        self.drawn, self.words, self.paper, self.scanned = drawn, words, paper, scanned
        self.way, self.end = way  # which of WAYS, and 0 least, 1 usual, 2 greatest

    def without(self, edit):
        less = Case(self.name)
        less.__dict__.update(self.__dict__, edits={k: v for k, v in self.edits.items() if k != edit})
        return less


def edit_of(key):
    return (key["file"], key["table"], key["key"])


def special(edit, value):
    """What a value needs beside it."""
    file, table, key = edit
    if (file, table) == ("scene", "prints"):
        return {("scene", "beating", "energy"): "0.03"}
    if key == "network":
        return {("exhibit", "phone", "address"): '"http://1"'}
    if file == "glaze" and key.startswith("band_"):
        return {("glaze", "", "band"): '"#2F4B7C"'}
    if file == "glaze" and key == "slip_cover":
        return {("glaze", "", "slip"): '"#E7E4DD"'}
    return {}


def every_case(keys):
    ranged = [key for key in keys if "ends" in key]
    texts = [key for key in keys if "letters" in key]
    cases = [Case("control")]
    for key in ranged:
        edit = edit_of(key)
        for end, value in zip(("least", "most"), key["ends"]):
            mission = {"litres": "describe", "height_mm": "describe", "mouth_mm": "describe"}.get(key["key"]) if key["file"] == "mission" else None
            cases.append(Case(f"{key['file']}.{key['table']}.{key['key']}={end}", {edit: value, **special(edit, value)},
                              mission=mission, paper=key["file"] == "paper"))
    for writing in (*WRITINGS, "lines"):
        language = WRITINGS.get(writing, ("en",))[0]
        cases.append(Case(f"texts={writing}", {edit_of(key): json.dumps(text_of(key, writing), ensure_ascii=False) for key in texts},
                          language))
        cases.append(Case(f"texts={writing}, read as a mission",
                          {edit_of(key): json.dumps(text_of(key, writing), ensure_ascii=False) for key in texts}, language, "eyes_closed"))
    for key, writing in zip(texts, itertools.cycle((*WRITINGS, "lines"))):
        cases.append(Case(f"{key['file']}.{key['key']}={writing}", {edit_of(key): json.dumps(text_of(key, writing), ensure_ascii=False)},
                          WRITINGS.get(writing, ("en",))[0]))
    for rows, sectors in GRIDS:
        cases.append(Case(f"grid={rows}x{sectors}", {("scene", "clay", "rows"): str(rows), ("scene", "clay", "sectors"): str(sectors)}))
    cases += [Case(f"shelf={count}", shelf=count) for count in (1, 12, 200, 500)]
    cases += [Case(f"mission={kind}", mission=kind) for kind in MISSIONS]
    cases.append(Case("drawing=500 points a wall", drawn=True))
    cases += [Case(f"scan={2 * (rows - 1) * sectors} triangles, {side} pixels", scanned=(rows, sectors, side)) for rows, sectors, side in SCANS]
    cases += [Case(f"way={('first', 'second')[way]}, {('least', 'usual', 'greatest')[end]}", way=(way, end)) for way in (0, 1)
              for end in (0, 1, 2) if (way, end) != (0, 1)]
    cases.append(Case("language=each text as long as it may be", words=True))
    for end in (0, 1):
        edits = {edit_of(key): key["ends"][end] for key in ranged if key["file"] != "paper"}
        edits.update(grid_at((8, 16) if end == 0 else (512, 8192)))
        for edit, value in list(edits.items()):
            edits.update(special(edit, value))
        if end == 1:
            edits.update({edit_of(key): json.dumps(text_of(key, "wide")) for key in texts})
        cases.append(Case("all=" + ("least", "greatest")[end], edits, drawn=end == 1, words=end == 1, way=(0, 2 * end)))
    return cases


def grid_at(grid):
    return {("scene", "clay", "rows"): str(grid[0]), ("scene", "clay", "sectors"): str(grid[1])}


def mix(keys, seed):
    """Each key at an end, or as it ships, by chance; each text in a writing."""
    draw = random.Random(seed)
    paper = draw.random() < 0.1
    edits = {}
    for key in keys:
        if (key["file"] == "paper") != paper and key["file"] in ("paper", "scene"):
            continue
        if draw.random() < 0.3:
            continue
        edit = edit_of(key)
        if "ends" in key:
            edits[edit] = draw.choice(key["ends"])
            edits.update(special(edit, edits[edit]))
        else:
            edits[edit] = json.dumps(text_of(key, draw.choice((*WRITINGS, "lines"))), ensure_ascii=False)
    if not paper:
        edits.update(grid_at(draw.choice(GRIDS)))
    mission = draw.choice((None, None, None, *MISSIONS))
    return Case(f"mix={seed}", edits, draw.choice(("en", "ko", "ar", "ja")), mission, draw.choice((1, 2, 12)), draw.random() < 0.3,
                draw.random() < 0.3, paper, way=(draw.choice((0, 1)), draw.choice((0, 1, 2))))


class Site:
    def __init__(self, folder):
        self.folder, self.exhibit = folder, os.path.join(folder, "config", "exhibit.toml")
        self.lines = {}  # (file, line): the edit that stands there

    def edit_at(self, file, line):
        """The edit that check means by that line: the one there, or at a table's line the table's first."""
        file = os.path.realpath(file)
        if (file, line) in self.lines:
            return self.lines[(file, line)]
        below = [edit for (at, n), edit in sorted(self.lines.items()) if at == file and n > line]
        of_table = [edit for edit in below if edit[1] == below[0][1]]
        return of_table[0] if of_table else None

    def write(self, path, tables, edits):
        """`tables`: [(header, {key: value})]; `edits`: [{key: edit}] in the same order."""
        path = os.path.join(self.folder, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        lines = []
        for (header, values), of in zip(tables, edits):
            if header:
                lines.append(header)
            for key, value in values.items():
                lines.append(f"{key} = {value}")
                if key in of:
                    self.lines[(os.path.realpath(path), len(lines))] = of[key]
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")


def tables_of(case, file, usual):
    """`usual`: {table: {key: value}}, with the case's edits of that file; [(header, values)] and [{key: edit}]."""
    values = {table: dict(of) for table, of in usual.items()}
    edits = {table: {} for table in values}
    for edit, value in case.edits.items():
        if edit[0] != file:
            continue
        key = case.language if edit[1] == "title" else edit[2]
        values.setdefault(edit[1], {})[key] = value
        edits.setdefault(edit[1], {})[key] = edit
    names = sorted(values, key=lambda table: table != "")
    return [(f"[{name}]" if name else "", values[name]) for name in names], [edits.get(name, {}) for name in names]


def entries(case, file, name, count, usual, texts):
    """`count` tables [[name]], each with the case's edits."""
    tables, edits = [], []
    own = {edit[2]: (edit, value) for edit, value in case.edits.items() if edit[0] == file}
    for n in range(count):
        values = {"id": f'"{file}_{n}"', **usual(n)}
        of = {}
        for key, (edit, value) in own.items():
            if key not in texts:
                values[key], of[key] = value, edit
        for key, words in texts.items():
            value = own[key][1] if key in own else json.dumps(words)
            values[f"{key}.{case.language}"] = value
            if key in own:
                of[f"{key}.{case.language}"] = own[key][0]
        tables.append((f"[[{name}]]", values))
        edits.append(of)
    return tables, edits


def drawing():
    """A jar of 500 points a wall."""
    outer = [f"[{60 + 40 * n * (499 - n) / 62250:.4f}, {200 * n / 499:.4f}]" for n in range(500)]
    inner = [f"[{52 + 40 * n * (499 - n) / 62250:.4f}, {200 - 190 * (499 - n) / 499:.4f}]" for n in range(499, 0, -1)]
    return ('title = "Jar"\nsource = "Nowhere"\nunits = "mm"\nouter = [' + ", ".join(outer) + "]\ninner = [" + ", ".join(inner) + ", [0, 10]]\n")


def write_shelf(site, case, root, onggi):
    vessels = sorted(os.listdir(os.path.join(root, "content/vessels")))
    for n in range(case.shelf):
        name = f"vessel_{n:04}"
        folder = os.path.join(site.folder, "content/vessels", name)
        os.makedirs(folder)
        drawn = os.path.join(folder, "profile.toml")
        if case.drawn and n == 0:
            with open(drawn, "w", encoding="utf-8") as file:
                file.write(drawing())
            subprocess.run([onggi, "vessel", "make", drawn, "-o", os.path.join(folder, "vessel.glb")], check=True, capture_output=True)
        else:
            for name_of in ("profile.toml", "vessel.glb"):
                shutil.copy(os.path.join(root, "content/vessels", vessels[(n + 5) % len(vessels)], name_of), folder)
        if case.scanned and n == 0:
            scan.write(os.path.join(folder, "vessel.glb"), *case.scanned)
            os.remove(drawn)
        label = f"label.{case.language}"
        usual = {"": {"drawing": '"profile.toml"', "true_height_mm": "305", "institution": '"A museum"', "source": '"A book"',
                      "credit": '"A museum"', "licence": '"CC0-1.0"'},
                 label: {"title": f'"Jar {n}"', "culture": '"Here"', "date": '"Now"', "made": '"By hand."', "text": '"A jar."'}}
        if case.scanned and n == 0:
            del usual[""]["drawing"]
        tables, edits = tables_of(case, "pack", usual)
        for edit, value in case.edits.items():
            if edit[0] == "label":
                of = next(i for i, (header, _) in enumerate(tables) if header == f"[{label}]")
                tables[of][1][edit[2]] = value
                edits[of][edit[2]] = edit
        site.write(f"content/vessels/{name}/vessel.toml", tables, edits)


def write_way(site, case):
    """The way of every vessel on the shelf. A figure has as many points as one may have, or a few."""
    own = {edit[2]: (edit, value) for edit, value in case.edits.items() if edit[0] == "way"}
    tables, edits = [], []

    def table(header, values, **texts):
        of = {}
        for key, words in texts.items():
            values[f"{key}.{case.language}"] = own[key][1] if key in own else json.dumps(words)
            if key in own:
                of[f"{key}.{case.language}"] = own[key][0]
            values.setdefault(f"{key}.en", json.dumps(words))
        tables.append((header, values))
        edits.append(of)

    table("", {"sources": '"A book"', "simplified": '"All of it"'}, name="A way", about="Paint.")
    for name, color, hides in (("white", "#FFFFFF", (1, 60, 1000)), ("black", "#000000", (1000, 15, 1))):
        table(f"[pigment.{name}]", {"color": f'"{color}"', "hides_um": hides[case.end]}, name=name)
    ring = [[round(0.5 * math.cos(2 * math.pi * n / 9), 4), round(0.5 * math.sin(2 * math.pi * n / 9), 4)] for n in range(9)]
    # As many points as a figure may have, and as long as a tool of 40 mm may draw it.
    knots = [[[round(0.07 * math.cos(n + t) + 0.3 * math.cos(1.6 * t), 4), round(0.07 * math.sin(n + t) + 0.3 * math.sin(1.6 * t), 4)]
              for n in (6.3 * m / 499 for m in range(500))] for t in range(4)]
    drawn = "{points = " + "}, {points = ".join(str(one) for one in (knots if case.end == 2 else [ring])) + "}"
    table("[motif.leaf]", {"line" if case.end == 2 else "fill": f"[{drawn}]"}, name="Leaf")
    for n, (law, hand, more, keys) in enumerate(WAYS[case.way]):
        values = {"id": f'"tool_{n}"', "law": f'"{law}"', "hand": f'"{hand}"'}
        if more:
            key, _, value = more.partition(" = ")
            values[key] = value
        if hand == "figure":
            values["motifs"] = '["leaf"]'
        values.update({key: ends[case.end] for key, ends in keys.items()})
        if hand in ("line", "figure"):
            values["repeats"] = (5, 8, 12)[case.end]
        table("[[tool]]", values, name=f"Tool {n}", how="Touch the pot.", did="a thing")
    site.write("content/ways/slip_painted.toml", tables, edits)


def write_words(site, case, root):
    shutil.copytree(os.path.join(root, "content/languages"), os.path.join(site.folder, "content/languages"))
    for name in os.listdir(os.path.join(site.folder, "content/languages")):
        path = os.path.join(site.folder, "content/languages", name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        # Only the language's own words: its tables of vessels and missions are of another shelf.
        keep, on = [], True
        for line in text.splitlines():
            if line.startswith("["):
                on = line.startswith("[text")
            if on:
                keep.append(lengthened(line) if case.words and name == f"{case.language}.toml" and " = \"" in line else line)
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(keep) + "\n")


def lengthened(line):
    """A language's line as long as an English one of its length may be translated, with words of the longest kind."""
    key, _, words = line.partition(" = ")
    if key in ("code", "name", "right_to_left", "decimal", "list", "sentences") or not words.startswith('"') or "{" in words:
        return line
    text = json.loads(words[:words.rindex('"') + 1])
    bound = {"letters": 2 * len(text) + 18, "wide": False, "lines": False}
    return f"{key} = {json.dumps((text + ' ' + text_of(bound, 'wide'))[:bound['letters']].strip(), ensure_ascii=False)}"


def write(case, root, folder, onggi):
    """`onggi`: the program, which makes a drawn vessel."""
    shutil.rmtree(folder, ignore_errors=True)
    site = Site(folder)
    languages = f'["{case.language}"]'
    usual = {"": {"languages": languages, "scene": '"scenes/scene.toml"'}, "keepsake": {"folder": '"../../keepsakes"'},
             "title": {case.language: '"Make a pot"'}}
    tables, edits = tables_of(case, "exhibit", usual)
    site.write("config/exhibit.toml", tables, edits)
    scene = {"paper": {}} if case.paper else {effect: {} for effect in EFFECTS}
    tables, edits = tables_of(case, "paper" if case.paper else "scene", scene)
    site.write("config/scenes/scene.toml", tables, edits)
    tables, edits = tables_of(case, "rubric", {})
    site.write("config/rubric.toml", tables, edits)
    write_shelf(site, case, root, onggi)
    write_way(site, case)
    write_words(site, case, root)
    colors = {"body": '"#AA7652"', "glass": '"#9DB5A0"'}
    site.write("content/glazes.toml", *entries(case, "glaze", "glaze", 8, lambda n: colors, {"name": "Celadon", "about": "Green."}))
    hands = ("around", "inside", "up", "along", "rim", "wire")
    until = ("touched", "opened", "raised", "shaped", "rim", "cut")
    site.write("content/lessons/first_minute.toml",
               *entries(case, "step", "step", 12, lambda n: {"hands": f'"{hands[n % 6]}"', "until": f'"{until[n % 6]}"'},
                        {"words": "Touch the clay."}))
    kinds = [case.kind] + [kind for kind in MISSIONS if kind != case.kind] + ["today", "eyes_closed"] if case.kind else []
    tables, edits = entries(case, "mission", "mission", len(kinds),
                            lambda n: {"kind": f'"{kinds[n]}"', **({"litres": "1.0"} if kinds[n] == "describe" else {})},
                            {"title": "A task", "about": "Make it."})
    for (_, values), of in zip(tables, edits):
        if values["kind"] != '"describe"':
            for key in ("litres", "height_mm", "mouth_mm"):
                values.pop(key, None)
                of.pop(key, None)
    site.write("content/missions.toml", tables, edits)
    return site
