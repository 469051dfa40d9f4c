"""Pages say what is so: what they name exists, what they hold to a source stands there. house.py calls it.

A file in the folder claims beside a page, of the page's name, holds the page's words to their source, a line each below
the heading of their section. (engine/docs/claims/clay.txt for engine/docs/clay.md; tests/house/claims/config/README.txt for
config/README.md, since only folders called docs have room for one.)

    # The heading, as the page has it
    8192 elements a tick | engine/scene/lump_work.cpp | kBudget = 8192

The words must stand in that section of the page, the source text in that file. Whoever changes either is told of the
other.
"""

import os
import re

CODE = (".h", ".cpp", ".glsl", ".py", ".toml", ".txt", ".cmake", ".json", ".in", ".gp")
PICTURES = "kiosk/docs/pictures"
DRAWN_BY = f"{PICTURES}/draw"
TABLE_MARKS = ("The table is written by", "end of the table")  # room_table.py
COMMENT = re.compile(r"<!--(.*?)-->", re.S)
CLAIMS = re.compile(r"(?:tests/house/claims/(.+)|(.+/docs(?:/\w+)*)/claims/([^/]+))\.txt")
HEADING = re.compile(r"#+ +(.*)")
# Made by a build or an installation, or an example's.
ELSEWHERE = re.compile(r"^(?:build|include|lib|keepsakes|/tmp|\.\./shared)(?:/|$)|my_jar|[A-Z]{4}")
NAME = re.compile(r"[A-Za-z_]\w*(?:(?:::|\.)~?\w+)*(?:\(\))?")


def plain(text):
    return " ".join(text.split())


def whole(words, text):
    """True where `text` has `words`, and not as a part of a longer word or figure."""
    return re.search(r"(?<!\w)" + re.escape(words) + r"(?![\w]|\.\d)", text) is not None


def page_of(name):
    """The page that a file of claims is of; None where it is no file of claims."""
    found = CLAIMS.fullmatch(name)
    return found and (found[1] or f"{found[2]}/{found[3]}") + ".md"


def sections(text):
    """{heading: all words below it}, a code block's own # left alone."""
    found, heading, code = {}, "", False
    for line in COMMENT.sub(" ", text).splitlines():
        code = code != line.startswith("```")
        head = None if code else HEADING.match(line)
        if head:
            heading = plain(head[1])
        found[heading] = found.get(heading, "") + " " + (plain(head[1]) if head else line)
    return {head: plain(words) for head, words in found.items()}


def held_words(name, page, text, read):
    """Yields what is wrong with the file of claims `name`, whose page says `text`."""
    if text is None:
        yield f"{name}: {page} is gone. Remove its claims, or move them to the page that has the words now."
        return
    section, here = None, sections(text)
    for number, line in enumerate(read(name).splitlines(), 1):
        where = f"{name}:{number}: "
        head = HEADING.match(line)
        if head:
            section = here.get(plain(head[1]))
            if section is None:
                yield f"{where}{page} has no heading '{plain(head[1])}'."
        elif line.strip():
            parts = [plain(part) for part in line.split(" | ")]
            if len(parts) != 3:
                yield f"{where}write 'words | file | source text', not '{line.strip()}'."
                continue
            words, source_name, wanted = parts
            source = read(source_name)
            if not whole(words, section or ""):
                yield f"{where}this section of {page} does not say '{words}' any more. Correct the claim."
            if source is None:
                yield f"{where}{source_name} is gone: where does '{words}' come from now?"
            elif not whole(wanted, plain(source)):
                yield (f"{where}{source_name} has no '{wanted}' any more. Look whether '{words}' is still "
                       "so, and correct page and claim.")


def loose_comments(page, text):
    """Yields the comments of a page, which nobody sees on the page. A program's marks round its table may stay."""
    for comment in COMMENT.finditer(text):
        if not comment.group(1).strip().startswith(TABLE_MARKS):
            where = f"{page}:{text[:comment.start()].count(chr(10)) + 1}: "
            yield f"{where}no reader sees a comment. A claim stands in the folder claims (tests/house/page_truth.py)."


def anchor(heading):
    """What a link to a heading says behind its #."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def named_things(page, pages, files, sources):
    """Yields the links, files and names of a page that lead nowhere."""
    prose = COMMENT.sub("", pages[page])
    for target, place in re.findall(r"\]\(([^)#\s]*)(?:#([^)]*))?\)", prose):
        path = os.path.normpath(os.path.join(os.path.dirname(page), target)) if target else page
        if "://" in target:
            continue
        if not any(f == path or f.startswith(path + "/") for f in files):
            yield f"{page}: the link {target} leads nowhere."
        elif place and path in pages and place not in map(anchor, sections(pages[path])):
            yield f"{page}: {path} has no heading for #{place}."
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
    claims = {name: page_of(name) for name in files if page_of(name)}
    code = "\n".join(filter(None, (read(name) for name in files if name not in claims
                                   and (name.endswith(CODE) or "." not in os.path.basename(name)))))
    broken = []
    for page, text in pages.items():
        broken += loose_comments(page, text)
        broken += named_things(page, pages, files, code)
    for name, page in claims.items():
        broken += held_words(name, page, pages.get(page), read)
    held = sum(read(name).count(" | ") // 2 for name in claims)
    broken += pictures(pages, files, read(DRAWN_BY) or "")
    return broken, f"{len(pages)} pages name what exists, {held} of their figures are held to their sources"
