"""The names that engine headers put straight into `onggi::`: what a library's user reads and writes.

tests/house/public_names.txt lists them by room. A new one is added there on purpose; all else lies in
a namespace of its room (onggi::effects, onggi::scene ...). house.py calls check().
"""

import re

LIST = "tests/house/public_names.txt"


def without_templates(text):
    """`template <class T, class U = V<T>> struct S` -> `struct S`."""
    while (found := re.search(r"\btemplate\s*<", text)):
        depth, end = 1, found.end()
        while end < len(text) and depth:
            depth += {"<": 1, ">": -1}.get(text[end], 0)
            end += 1
        text = text[:found.start()] + text[end:]
    return " ".join(text.split())


def name_of(declaration):
    """The name that a declaration or the head of a definition declares; None where it is none."""
    text = re.sub(r"\[\[.*?\]\]|\brequires\b.*", "", without_templates(declaration)).strip()
    if re.fullmatch(r"(?:struct|class) \w+", text):
        return None  # declared elsewhere
    if not text or text.startswith(("static_assert", "using namespace", "friend")):
        return None
    found = re.match(r"(?:struct|class|union|enum(?: class| struct)?) (\w+)", text)
    found = found or re.match(r"using (\w+) =", text)
    if found:
        return found.group(1)
    if "operator" in text or text.startswith("using "):
        return None
    head = re.split(r"[=({]", text)[0]
    found = re.search(r"(\w+)\s*(?:\[[^\]]*\])?\s*$", head)
    return found.group(1) if found and " " in head.strip() else None


def public_names(source):
    """Names that `source` declares in the namespace onggi itself."""
    source = re.sub(r"//[^\n]*|/\*.*?\*/", "", source, flags=re.S)
    source = re.sub(r'"(?:\\.|[^"\\])*"', '""', source)
    source = re.sub(r"'(?:\\.|[^'\\])'", "' '", source)
    source = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", source, flags=re.M)
    names, scopes, text = set(), [], ""
    for letter in source:
        if letter not in "{};":
            text += letter
            continue
        inside = re.search(r"\bnamespace(?:\s+([\w:]+))?\s*$", text)
        if letter != "}" and not inside and scopes == ["onggi"]:
            names.add(name_of(text + ("" if letter == ";" else " {")))
        if letter == "{":
            scopes.append(inside.group(1) if inside else None)
        if letter == "}" and scopes:
            scopes.pop()
        text = ""
    return names - {None}


def check(files, read, room_of):
    """What is broken, and a line for when nothing is. `read` gives a file's text."""
    declared, listed, broken = {}, {}, []
    for name in files:
        if name.startswith("engine/") and name.endswith(".h") and room_of(name):
            for each in public_names(read(name)):
                declared.setdefault((room_of(name), each), name)
    for number, line in enumerate(read(LIST).splitlines(), 1):
        room, colon, names = line.split("#")[0].partition(" : ")
        if colon:
            listed.update({(room.strip(), each): number for each in names.split()})
    for (room, each), name in sorted(declared.items()):
        if (room, each) not in listed:
            broken.append(f"{name}: {each} is a new name in onggi::. Put it into "
                          f"onggi::{room.split('/')[1]}, or, if a library's user wants it and it is "
                          f"not too plain, list it in {LIST}.")
    for (room, each), number in sorted(listed.items()):
        if (room, each) not in declared:
            broken.append(f"{LIST}:{number}: {room} has no {each} in onggi:: any more. Remove it.")
    return broken, f"{len(declared)} names lie in onggi::, each on purpose"
