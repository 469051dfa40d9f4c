"""What the staff's page says, and the languages that it says it in: every text is there in each, once, and nothing else is.

usage: staff_words.py --onggi build/.../onggi              checks content/staff/*.toml; skipped (77) where onggi is not built
       staff_words.py --onggi build/.../onggi --list CODE  what that language still lacks, as TOML to be filled in
"""
import argparse
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[4]
CONSOLE = ROOT / "kiosk/program/console"
FOR_EVERYBODY = ("base", "staff", "door")  # of page/*.js; editors alone get the others
TEXT = r'"((?:[^"\\]|\\.)*)"'
LITERAL = TEXT + r"(?:\s*" + TEXT + ")*"  # as the formatter breaks it
KEPT = {"maria.k"}  # the same in every language
# Said by a machine that is broken, or to who starts the program.
SELDOM = {"There is no memory to keep it safely.", "It gives no random numbers.", "This folder belongs to another user.", "This is nobody of the staff."}


class Page(html.parser.HTMLParser):
    """The texts of a page, and of those attributes that are read: (text, whether it is for editors alone)."""

    def __init__(self, file):
        super().__init__()
        self.texts, self.open, self.quiet = [], [], 0
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        fields = dict(attributes)
        if tag not in ("meta", "link", "input", "img", "br"):
            self.open.append((tag, "data-editors" in fields or any(editors for _, editors in self.open)))
        for name in ("placeholder", "title", "aria-label"):
            if fields.get(name):
                self.note(fields[name])

    def handle_endtag(self, tag):
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data):
        if data.strip() and not any(tag in ("code", "noscript") for tag, _ in self.open):
            self.note(data.strip())

    def note(self, text):
        if text not in KEPT:
            self.texts.append((text, bool(self.open) and self.open[-1][1]))


def literal(found):
    return json.loads('"' + "".join(re.findall(TEXT, found)) + '"')


COUNTING = set()  # the texts that may have a form for each kind of number


def in_script(file):
    text = file.read_text()
    for found in re.finditer(r"\bt\((" + TEXT + r")", text):
        yield literal(found[1])
    for found in re.finditer(r"\btn\(.*?, " + TEXT + ", (" + TEXT + ")", text):
        COUNTING.add(literal(found[2]))
        yield literal(found[2])
    for found in re.finditer(r"\b(?:what|remedy): (" + TEXT + ")", text):  # as if the program had said it
        if literal(found[1]):
            yield literal(found[1])


def in_program():
    """What the program says in fixed words."""
    for file in sorted(CONSOLE.glob("*.cpp")):
        if file.stem in ("console_main", "page_words", "served_at", "state_report"):
            continue  # they say it to a terminal; the last one follows
        source = file.read_text()
        # What is wrong, and what to do: refused(), problem(), failed().
        texts = list(LITERAL_WHOLE.finditer(source))
        for what, remedy in zip(texts, texts[1:]):
            between, after = source[what.end():remedy.start()], source[remedy.end():remedy.end() + 1]
            if re.fullmatch(r",\s*", between) and after in ",)" and re.match(r"[A-Z].* .*\.$", literal(what[0])) and literal(what[0]) not in SELDOM:
                yield from ((file, literal(text[0])) for text in (what, remedy))
        for found in re.finditer(r'"(?:what|remedy)", (' + LITERAL + ")", source):
            yield file, literal(found[1])
    file = CONSOLE / "state_report.cpp"
    text = re.sub(r"^(#.*| *//.*|.*snprintf.*|.*local_time.*\"%.*)$", "", file.read_text(), flags=re.M)
    for found in re.finditer(r"counting\([^\"]+,\s*" + LITERAL + r",\s*(" + LITERAL + ")", text):
        COUNTING.update(literal(one) for one in LITERAL_WHOLE.findall(found[0])[1:])
    text = re.sub(r"counting\(([^\"]+),\s*" + LITERAL + ",", r"(\1,", text)
    for found in re.finditer(LITERAL, text):
        words = literal(found[0])
        if words == words.strip() and (words[:1].isupper() or " " in words):
            yield file, words


IN_WORDS = {"s", "hours", "days", "months", "litres", "coils", "ticks", "pixels"}  # units; the others are the same everywhere
LITERAL_WHOLE = re.compile(r'(?:"(?:[^"\\]|\\.)*"\s*)+')


def sentence(words):
    plain = words.replace("`", "")
    return (plain if re.match("m,|http", plain) else plain[:1].upper() + plain[1:]) + "."


def as_label(key):
    words = re.sub(r"_(mm|mb|px)$", "", key).replace("_", " ")
    return words[:1].upper() + words[1:]


def in_fields(onggi):
    """What the forms say of the files' keys (fieldRow in edit.js)."""
    scripts = {name: (CONSOLE / f"page/{name}.js").read_text() for name in ("settings", "scenes", "shelf", "lists")}

    def keys(script, name):
        block = re.search(rf"const {name} = {{(.*?)\n}};", scripts[script], re.S)[1]
        return set(a or b for a, b in re.findall(r'(?:"([^"]+)"|(\w+)): t\(', block))

    lists = {one["file"]: one for one in json.loads(subprocess.run([onggi, "check", "--fields", "--json", "-"], check=True, capture_output=True, text=True).stdout)}
    labels = {"exhibit.toml": keys("settings", "LABELS"), "scenes/*.toml": keys("scenes", "SCENE_LABELS"), "vessel.toml": keys("shelf", "ABOUT") | keys("shelf", "LABEL_WORDS")}
    helps = {"exhibit.toml": keys("settings", "HELP")}
    of_lists = keys("lists", "LIST_LABELS")
    sections = re.findall(r'"([\w.]+)"', re.search(r"const SECTIONS = \[(.*?)\n\];", scripts["settings"], re.S)[1])
    of_scenes = set(re.findall(r'"(\w+)"', re.search(r"const SCENE_TABLES = (.*?);", scripts["scenes"], re.S)[1])) | keys("scenes", "EFFECTS")
    sizes = re.search(r'Sizes of the tools"\), \[(.*?)\]', scripts["scenes"])[1]
    for file, one in lists.items():
        if file.startswith("devices"):
            continue  # has no form
        for field in one["fields"]:
            name = (field["table"] + "." if field["table"] else "") + field["key"]
            if name in ("order", "hidden", "languages", "id") or field["key"] == "id" or (file == "vessel.toml" and name not in labels[file] and not field["table"].startswith("label")):
                continue
            if file == "exhibit.toml" and not field["any_key"] and not any(name.startswith(key) if key.endswith(".") else name == key for key in sections):
                continue
            if file.startswith("scenes") and field["table"] not in of_scenes and name != "quality":
                continue
            size = file.startswith("scenes") and f'"{field["table"]}"' in sizes
            known = labels.get(file, of_lists)
            if size:
                yield from (as_label(field["table"]), field["key"])
            elif name not in known and field["key"] not in known and not field["any_key"]:
                yield as_label(field["key"])
            hours = name.startswith("hours.") and name != "hours.screen_off"
            silent = file == "vessel.toml" or field["any_key"] or hours or size or name in ("scene", "built_scene", "tool.to_hand", "quality", "attract.scripts")
            if not silent and name not in helps.get(file, ()) and sentence(field["words"]) != as_label(field["key"]) + ".":
                yield sentence(field["words"])
            if field["kind"] != "boolean" and not field.get("choices") and "least" not in field and field["allowed"] and not hours and \
                    not (file == "exhibit.toml" and field["any_key"]) and name not in ("tool.to_hand", "attract.scripts"):
                yield sentence(field["allowed"])
            usual = field.get("default", "").replace('"', "")
            for choice in [*field.get("choices", ()), *([usual] if field.get("choices") and usual else [])]:
                if name not in ("scene", "built_scene") and not (field["key"] == "kind"):
                    yield choice.replace("_", " ")
            if usual and field["kind"] != "boolean" and not field.get("choices") and re.fullmatch(r"[a-z0-9 ]*[a-z]{2}[a-z ]*", field["default"]):
                yield usual
            if field["kind"] != "boolean" and field.get("unit", "") in IN_WORDS:
                yield field["unit"]
        for table in one["tables"]:
            if file.startswith("scenes"):
                yield re.sub(r"([^.])$", r"\1.", table["words"])
                if table.get("gives"):
                    yield table["gives"]


def in_scenes():
    """The names of the scenes that come with the program, and what they are for (settings::words_of_scene)."""
    for file in sorted((ROOT / "config/scenes").glob("*.toml")):
        yield as_label(file.stem)
        words = " ".join(line[1:].strip() for line in re.match(r"(?:#.*\n)*", file.read_text())[0].splitlines())
        said = [one for one in re.split(r"(?<=\.) ", words) if ".md" not in one and
                not one.startswith(("What each", "An effect is", "The exhibit's", "These are the engine's"))]
        yield " ".join(said)


def texts(onggi):
    """{text: whether it is for editors alone}, in the order of the page."""
    found = {}

    def note(text, editors):
        if not text:
            return
        found[text] = found.get(text, True) and editors

    for name in ("door", "staff"):
        for text, editors in Page(CONSOLE / f"page/{name}.html").texts:
            note(text, editors)
    for name in FOR_EVERYBODY:
        for text in in_script(CONSOLE / f"page/{name}.js"):
            note(text, False)
    for file, text in in_program():
        note(text, file.stem.startswith(("edit", "scan", "scene", "screen")))
    for file in sorted((CONSOLE / "page").glob("*.js")):
        if file.stem not in FOR_EVERYBODY + ("print",):
            for text in in_script(file):
                note(text, True)
    for text in [*in_fields(onggi), *in_scenes()]:
        note(text, True)
    return found


def names_in(words):
    return sorted(set(re.findall(r"\{\w+\}", words)))


def faults(file, wanted):
    language = tomllib.loads(file.read_text())
    for part, editors in (("page", False), ("editors", True)):
        has, needs = language.get(part, {}), [text for text, of in wanted.items() if of == editors]
        yield from (f"[{part}] lacks: {text}" for text in needs if text not in has)
        for text, own in has.items():
            if text not in needs:
                yield f"[{part}] has what the page does not say there: {text}"
            for form, words in own.items() if isinstance(own, dict) else [("", own)]:
                # "One pot" needs no number.
                missing = set(names_in(text)) - set(names_in(words)) - ({"{count}"} if form in ("zero", "one", "two") else set())
                if missing or set(names_in(words)) - set(names_in(text)):
                    yield f"[{part}] {form or 'it'} names other things in braces: {text} -> {words}"
                if words.strip() != words or not words:
                    yield f"[{part}] is empty, or has blanks at an end: {text}"
            if isinstance(own, dict) and ("other" not in own or text not in COUNTING):
                yield f"[{part}] has forms for numbers, and none for others or no number: {text}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--onggi", required=True)
    parser.add_argument("--list")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.onggi).exists():
        print("onggi is not built here, and it knows the fields of the files.")
        return 77
    wanted = texts(arguments.onggi)
    files = sorted((ROOT / "content/staff").glob("*.toml"))
    if arguments.list:
        file = ROOT / f"content/staff/{arguments.list}.toml"
        has = tomllib.loads(file.read_text()) if file.exists() else {}
        for part, editors in (("page", False), ("editors", True)):
            print(f"[{part}]")
            for text in (text for text, of in wanted.items() if of == editors and text not in has.get(part, {})):
                print(json.dumps(text, ensure_ascii=False), '= ""')
        return 0
    found = [f"{file.name}: {fault}" for file in files for fault in faults(file, wanted)]
    print("\n".join([*found, f"{len(found)} faults in {len(files)} languages of {len(wanted)} texts."]))
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
