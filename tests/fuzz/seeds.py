#!/usr/bin/env python3
"""Writes what a fuzzer begins with: tests/fuzz/seeds.py document|parts FOLDER (tests/fuzz/run calls it)."""

import json
import os
import struct
import sys


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
    jar = struct.pack("<4s4I", b"ONGP", 1, 3, 4, 2) + b"jar"
    return [jar + struct.pack("<12f6I", *range(12), 0, 1, 2, 1, 2, 3), b"ONGEno such face"]


if __name__ == "__main__":
    os.makedirs(sys.argv[2], exist_ok=True)
    for i, seed in enumerate({"document": documents, "parts": parts}[sys.argv[1]]()):
        with open(os.path.join(sys.argv[2], "seed_%d" % i), "wb") as out:
            out.write(seed)
