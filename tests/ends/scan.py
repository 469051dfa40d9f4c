"""A jar as a scanner brings it: a GLB of many triangles with a large picture on it."""
import array
import json
import math
import struct
import zlib

OUTLINE = ((0.0, 0.0), (0.04, 0.0), (0.06, 0.1), (0.05, 0.2), (0.045, 0.2), (0.055, 0.1), (0.036, 0.006), (0.0, 0.006))  # m


def outline(count):
    """`count` points along it, and their share of its length."""
    lengths = [math.dist(a, b) for a, b in zip(OUTLINE, OUTLINE[1:])]
    for n in range(count):
        left = sum(lengths) * n / (count - 1)
        for (a, b), length in zip(zip(OUTLINE, OUTLINE[1:]), lengths):
            if left <= length + 1e-12:
                break
            left -= length
        s = min(1.0, left / length)
        yield a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), n / (count - 1)


def picture(side):
    """A PNG of `side` x `side` in stripes."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = [b"\0" + bytes((180 - 60 * stripe, 120, 90 + 40 * stripe)) * side for stripe in (0, 1)]
    packer = zlib.compressobj(1)
    data = b"".join(packer.compress(rows[y // 64 % 2]) for y in range(side)) + packer.flush()
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) + chunk(b"IDAT", data) +
            chunk(b"IEND", b""))


def write(path, rows, sectors, side):
    """A jar of 2 * (rows - 1) * sectors triangles, with a picture of `side` x `side` pixels."""
    turn = [(math.cos(2 * math.pi * k / sectors), math.sin(2 * math.pi * k / sectors)) for k in range(sectors)]
    places, uvs, corners = array.array("f"), array.array("f"), array.array("I")
    for radius, height, share in outline(rows):
        for k, (cos, sin) in enumerate(turn):
            places.extend((radius * cos, height, radius * sin))
            uvs.extend((k / sectors, share))
    for j in range(rows - 1):
        for k in range(sectors):
            a, b = j * sectors + k, j * sectors + (k + 1) % sectors
            corners.extend((a, a + sectors, b, b, a + sectors, b + sectors))
    parts = [places.tobytes(), uvs.tobytes(), corners.tobytes(), picture(side)]
    views, binary = [], b""
    for part in parts:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
        binary += part + b"\0" * (-len(part) % 4)
    count = rows * sectors
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "jar"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}], "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", "min": [-0.06, 0, -0.06], "max": [0.06, 0.2, 0.06]},
            {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5125, "count": len(corners), "type": "SCALAR"}],
        "bufferViews": views, "buffers": [{"byteLength": len(binary)}]}
    head = json.dumps(document).encode()
    head += b" " * (-len(head) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(head) + len(binary), len(head), 0x4E4F534A) + head)
        file.write(struct.pack("<II", len(binary), 0x004E4942) + binary)
