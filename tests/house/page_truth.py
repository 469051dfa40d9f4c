"""Pages say what is so: what they name exists, what they hold to a source stands there. house.py calls it.

A page holds its words to their source by a comment below them, a line each:

    <!-- true while
    8192 elements a tick | engine/scene/lump_work.cpp | kBudget = 8192
    -->

The words must stand in the same section (since the last heading), the source text in that file. Whoever
changes either is told of the other.
"""

import os
import re

CODE = (".h", ".cpp", ".glsl", ".py", ".toml", ".txt", ".cmake", ".json", ".in", ".gp")
PICTURES = "kiosk/docs/pictures"
DRAWN_BY = f"{PICTURES}/draw"
TABLE_MARKS = ("The table is written by", "end of the table")  # room_table.py
COMMENT = re.compile(r"<!--(.*?)-->", re.S)
# Made by a build or an installation, or an example's.
ELSEWHERE = re.compile(r"^(?:build|include|lib|keepsakes|/tmp|\.\./shared)(?:/|$)|my_jar|[A-Z]{4}")
NAME = re.compile(r"[A-Za-z_]\w*(?:(?:::|\.)~?\w+)*(?:\(\))?")


def plain(text):
    return " ".join(text.split())


def whole(words, text):
    """True where `text` has `words`, and not as a part of a longer word or figure."""
    return re.search(r"(?<!\w)" + re.escape(words) + r"(?![\w]|\.\d)", text) is not None


def held_words(page, text, read):
    """Yields what is wrong with the `true while` comments of a page."""
    for comment in COMMENT.finditer(text):
        head, _, body = comment.group(1).strip().partition("\n")
        where = f"{page}:{text[:comment.start()].count(chr(10)) + 1}: "
        if head.startswith(TABLE_MARKS):
            continue
        if not head.startswith("true while"):
            yield f"{where}a comment holds nothing unless it begins with 'true while'."
            continue
        before = COMMENT.sub(" ", text[:comment.start()])
        section = plain(re.split(r"^#+ ", before, flags=re.M)[-1])
        for line in (head[len("true while"):] + "\n" + body).splitlines():
            if not line.strip():
                continue
            parts = [plain(part) for part in line.split(" | ")]
            if len(parts) != 3:
                yield f"{where}write 'words | file | source text', not '{line.strip()}'."
                continue
            words, name, wanted = parts
            source = read(name)
            if not whole(words, section):
                yield f"{where}this section does not say '{words}' any more. Correct the comment."
            if source is None:
                yield f"{where}{name} is gone: where does '{words}' come from now?"
            elif not whole(wanted, plain(source)):
                yield (f"{where}{name} has no '{wanted}' any more. Look whether '{words}' is still "
                       "so, and correct page and comment.")


def named_things(page, text, files, sources):
    """Yields the links, files and names of a page that lead nowhere."""
    prose = COMMENT.sub("", text)
    for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", prose):
        path = os.path.normpath(os.path.join(os.path.dirname(page), target))
        if "://" not in target and not any(f == path or f.startswith(path + "/") for f in files):
            yield f"{page}: the link {target} leads nowhere."
    listing = "\n" + "\n".join(files) + "\n"
    prose = re.sub(r"^```.*?^```", "", prose, flags=re.M | re.S)
    for span in dict.fromkeys(re.findall(r"`([^`\n]+)`", prose)):
        if ELSEWHERE.search(span) or "..." in span:
            continue
        if re.fullmatch(r"[\w.-]+(?:/[\w.*-]+)+/?", span) or re.fullmatch(r"\w+\.(?:h|cpp|py|md|toml|glsl|csv)", span):
            path = re.escape(span.rstrip("/")).replace(r"\*", "[^/\n]*")
            if not re.search(rf"[\n/]{path}(?:[\n/.]|_test\.)", listing):
                yield f"{page}: there is no {span}."
        elif NAME.fullmatch(span):
            for word in re.findall(r"\w+", span):
                room = word.replace("_", "/", 1)  # onggi::engine_profile
                if word not in sources and f"/{word}" not in listing and f"\n{room}/" not in listing:
                    yield f"{page}: nothing in the sources is called {word}, as in `{span}`."


def pictures(pages, files, draw):
    """Yields pictures that no page shows, or that the command does not draw, and the other way."""
    shown = "".join(pages.values())
    here = {os.path.basename(f) for f in files if f.startswith(PICTURES) and f.endswith(".png")}
    drawn = set(re.findall(r"(?<![\w*])([\w-]+\.png)", re.sub(r"^ *#.*", "", draw, flags=re.M)))
    for name in sorted(here):
        if f"pictures/{name})" not in shown:
            yield f"{PICTURES}/{name}: no page shows it. Remove it, here and in {DRAWN_BY}."
        if name not in drawn:
            yield f"{PICTURES}/{name}: {DRAWN_BY} does not draw it."
    for name in sorted(drawn - here):
        yield f"{DRAWN_BY}: draws {name}, which is not here. Run it, or remove it there."


def check(files, read):
    """What is wrong, and a line for when nothing is. `read` gives a file's text, None where it is gone."""
    pages = {name: read(name) for name in files if name.endswith(".md")}
    code = "\n".join(filter(None, (read(name) for name in files
                                   if name.endswith(CODE) or "." not in os.path.basename(name))))
    broken = []
    held = 0
    for page, text in pages.items():
        broken += held_words(page, text, read)
        broken += named_things(page, text, files, code)
        held += sum(comment.count(" | ") // 2 for comment in COMMENT.findall(text)
                    if comment.strip().startswith("true while"))
    broken += pictures(pages, files, read(DRAWN_BY) or "")
    return broken, f"{len(pages)} pages name what exists, {held} of their figures are held to their sources"
