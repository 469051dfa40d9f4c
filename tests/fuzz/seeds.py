#!/usr/bin/env python3
"""Writes what a fuzzer begins with: tests/fuzz/seeds.py document|parts|archive|texture|replay|staff FOLDER (tests/fuzz/run calls it)."""

import base64
import io
import json
import os
import struct
import sys
import zipfile
import zlib


def documents():
    """A IIIF manifest of 4.0, one of 3.0 that offers a scan on the web, and a Smithsonian document."""
    body = {"id": "jar.glb", "type": "Model", "format": "model/gltf-binary"}
    said = {"type": "Manifest", "label": {"en": ["Jar"], "ko": ["항아리"]}, "rights": "CC BY 4.0",
            "homepage": [{"id": "https://museum.org/1"}], "provider": [{"label": {"en": ["Museum"]}}],
            "requiredStatement": {"value": {"en": ["<b>Museum</b>"]}},
            "metadata": [{"label": {"en": ["Date"]}, "value": {"en": ["1700s"]}}]}
    scene = {"type": "Scene", "items": [{"items": [{"type": "Annotation", "body": body}]}]}
    model = {"units": "cm", "derivatives": [{"quality": "High", "assets": [{"uri": "jar.glb", "type": "Model"}]}]}
    voyager = {"asset": {"type": "application/si-dpo-3d.document+json", "copyright": "(c)"}, "models": [model],
               "metas": [{"collection": {"titles": {"EN": "Jar"}, "recordLink": "https://museum.org/1"}}]}
    all_of = [dict(said, items=[scene]), dict(said, rendering=[dict(body, id="https://museum.org/jar.glb")]), voyager]
    return [json.dumps(one, ensure_ascii=False).encode() for one in all_of]


def parts():
    """What onggi-mesh answers for two triangles, and a refusal."""
    jar = struct.pack("<4s5I", b"ONGP", 1, 3, 4, 2, 4) + b"jar"
    return [jar + struct.pack("<12f6I", *range(12), 0, 1, 2, 1, 2, 3) + bytes(range(12)), b"ONGEno such face"]


def archives():
    """A scan's folder as Python's zipfile packs it: stored, deflated, with a comment, for large files; and a link."""
    whole = []
    for packing, far in ((zipfile.ZIP_STORED, False), (zipfile.ZIP_DEFLATED, True)):
        out = io.BytesIO()
        with zipfile.ZipFile(out, "w", packing) as archive:
            archive.mkdir("jar") if hasattr(archive, "mkdir") else archive.writestr("jar/", b"")
            with archive.open("jar/scan.gltf", "w", force_zip64=far) as scan:
                scan.write(b"{}" * 40)
            archive.writestr("jar/항아리.bin", bytes(300))
            archive.writestr("__MACOSX/jar/._scan.gltf", b"x")
            archive.comment = b"from the museum"
        whole.append(out.getvalue())
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        link = zipfile.ZipInfo("link")
        link.create_system, link.external_attr = 3, 0o120777 << 16
        archive.writestr(link, "/etc/passwd")
    return [*whole, out.getvalue()]


def textures():
    """Pictures of 24 x 20 pixels: a progressive JPEG, WebP with and without loss, PNG; and the tests' KTX2."""
    whole = [base64.b64decode(text) for text in (
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVtVkVGZIhlbXd7"
        "gYKBTmCNl4x9lnN+gXz/2wBDARUXFx4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8"
        "fHx8fHx8fHz/wgARCAAUABgDASIAAhEBAxEB/8QAGAABAAMBAAAAAAAAAAAAAAAAAAIDBAX/xAAXAQADAQAAAAAAAAAAAAAAAAAB"
        "AgQF/9oADAMBAAIQAxAAAAHmXXXoM7cNkNAmRMJb/8QAGBABAQEBAQAAAAAAAAAAAAAAAQACEBH/2gAIAQEAAQUCMxmMxmM3kHAv"
        "/8QAGBEAAwEBAAAAAAAAAAAAAAAAAAIDASH/2gAIAQMBAT8BSgtOCGH/xAAaEQACAgMAAAAAAAAAAAAAAAAAAQIxEiEy/9oACAEC"
        "AQE/AVseCshyRo//xAAUEAEAAAAAAAAAAAAAAAAAAAAw/9oACAEBAAY/Ah//xAAXEAEBAQEAAAAAAAAAAAAAAAABABEg/9oACAEB"
        "AAE/IeRbMxQYRX//2gAMAwEAAgADAAAAELsYAP/EABcRAQEBAQAAAAAAAAAAAAAAAAABESH/2gAIAQMBAT8QzVK6u4//xAAYEQEB"
        "AQEBAAAAAAAAAAAAAAABABEhYf/aAAgBAgEBPxC9GLs0T5En/8QAGRAAAwADAAAAAAAAAAAAAAAAAAFhESFR/9oACAEBAAE/EIkC"
        "JEgJ0xlnILa0tnMf/9k=",
        "UklGRpQAAABXRUJQVlA4IIgAAABwBQCdASoYABQAPxF0sVEsJqSisAgBgCIJbACdMuz/doALn/88YnanVBR+/QUycUMA30WAAP77"
        "kpowqBNuPlGfBpISNj3QSMMmGNV8/bAnWzOtB6NmrKfvWSE1UQbuG1TENw9yzasp8x7LOFGTNUWXxQuZdGLFC3A0+UAQPVuGVq/e"
        "x5CyE4AA",
        "UklGRmAAAABXRUJQVlA4TFMAAAAvF8AEAAmAIAb8H3uI6H96IRZM5g/dFUT9o/8RB5q2jWQAxx/x/X/GH0dBcdtIam75+O7LEBMA"
        "iPVAsP4FhAgFuQ2JDoIJjQNGfLDan2j8iMQBjwA=")]

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    for colour, bits, interlaced, row in ((2, 8, 0, 72), (6, 16, 1, 192), (3, 4, 0, 12)):
        rows = b"".join(b"\1" + bytes((7 * x + 3 * y) % 256 for x in range(row)) for y in range(20 if not interlaced else 60))
        whole.append(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", 24, 20, bits, colour, 0, 0, interlaced)) +
                     (chunk(b"PLTE", bytes(range(48))) if colour == 3 else b"") +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    folder = os.path.join(os.path.dirname(__file__), "..", "kiosk", "textures", "samples")
    for name in sorted(os.listdir(folder)):
        if name.endswith(".ktx2"):
            with open(os.path.join(folder, name), "rb") as sample:
                whole.append(sample.read())
    return whole


def replays():
    """One of each version that tests/golden keeps: rows and columns."""
    folder = os.path.join(os.path.dirname(__file__), "..", "golden")
    return [open(os.path.join(folder, name), "rb").read() for name in sorted(os.listdir(folder))
            if name.endswith(".onggi")]


def staff():
    """A request of each kind that the staff's page answers, and a kiosk's state."""
    visit = "2026-05-28_141503_moon_jar"
    gets = ["/", "/staff.js", "/?code=abc", "/api/state?alone=1", "/api/files", "/api/figures?from=2026-05-01&to=2026-05-31",
            "/figures.svg", "/api/keepsakes?day=2026-05-28", "/api/keepsakes?name=blue+heron%20x", "/api/people",
            f"/keepsake/{visit}/postcard.jpg", f"/print/{visit}", "/api/changes", "/api/door",
            "/api/edit/exhibit", "/api/edit/vessel/jar", "/api/edit/vessel/..", "/api/shelf", "/api/saved", "/api/revisions",
            "/outline/jar", "/api/screen?number=1", "/screen/1/0", "/api/scenes", "/api/prices/soft", "/api/edit/scene/soft", "/api/edit/language/en"]
    posts = [("/api/screen", {"screen": "label", "vessel": "jar", "file": "exhibit", "changes": [["idle.warn_after", 90]]}),
             ("/api/screen/stop", {}), ("/api/enter", {"name": "maria", "passphrase": "three wet sponges"}), (f"/api/keepsakes/{visit}/delete", {}),
             (f"/api/keepsakes/{visit}/pass", {}), ("/api/people/maria/remove", {}), ("/api/passphrase", {"old": "", "new": ""}),
             ("/api/people", {"name": "maria", "role": "desk", "passphrase": "short"}), ("/api/undo", {}),
             ("/api/edit/exhibit/check", {"changes": [["idle.warn_after", 90], ["hours.exceptions.12-25", "closed"]]}),
             ("/api/edit/exhibit/save", {"tag": "x", "changes": [["credit", "한"], ["languages", ["en"]], ["order", None]]}),
             ("/api/prices/soft", {}), ("/api/edit/scene/soft/check", {"changes": [["slump", {}], ["moisture", None], ["clay.rows", 50]]}),
             ("/api/edit/language/en/check", {"changes": [["text.attract.begin", "{x}"]]}),
             ("/api/edit/exhibit/check", {"changes": [["scene", "scenes/soft.toml"]]}),
             ("/api/edit/vessel/jar/check", {"changes": [["label.en.title", "Jar"], ["drawing", "../x"], ["glazes", []]]})]
    state = "version 0.1.0\nsaid 1780000000\nframes_a_second 59.9\ndevice x\ntrouble_at 5\nwhat x\nend\n"
    return ([b"\x0f" + f"GET\n{g}\n\n".encode() for g in gets] +
            [b"\x0f" + f"POST\n{target}\n\n{json.dumps(body)}".encode() for target, body in posts] + [state.encode()])


if __name__ == "__main__":
    os.makedirs(sys.argv[2], exist_ok=True)
    kinds = {"document": documents, "parts": parts, "archive": archives, "texture": textures, "replay": replays, "staff": staff}
    for i, seed in enumerate(kinds[sys.argv[1]]()):
        with open(os.path.join(sys.argv[2], "seed_%d" % i), "wb") as out:
            out.write(seed)
