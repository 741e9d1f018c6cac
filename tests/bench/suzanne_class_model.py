"""A model of Suzanne's class, made by rule so that it need not be shipped: 4,000 triangles of a lumpy torus, with two PNG
textures of 1024² texels (base colour and emission) that deflate cannot shrink much."""

import json
import math
import struct
import zlib

COLUMNS, ROWS = 50, 40  # cells; two triangles each
SIDE = 1024


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(seed):
    """Stripes with noise, 8-bit RGB, rows filtered by "sub" as encoders commonly do."""
    state = seed
    rows = bytearray()
    for y in range(SIDE):
        row = bytearray(SIDE * 3)
        for x in range(SIDE):
            state = (state * 1664525 + 1013904223) & 0xFFFFFFFF
            base = 150 if (x // 64 + y // 64) % 2 else 70
            row[3 * x : 3 * x + 3] = (base + (state >> 28), base + (state >> 24 & 15), base + (state >> 20 & 15))
        rows.append(1)
        rows += row[:3]
        rows += bytes((row[i] - row[i - 3]) & 255 for i in range(3, len(row)))
    header = struct.pack(">IIBBBBB", SIDE, SIDE, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(rows), 6)) + chunk(b"IEND", b"")


def torus():
    """Positions, normals, texture coordinates and indices as bytes."""
    positions, normals, texcoords, indices = bytearray(), bytearray(), bytearray(), bytearray()
    for j in range(ROWS + 1):
        for i in range(COLUMNS + 1):
            around, along = 2 * math.pi * i / COLUMNS, 2 * math.pi * j / ROWS
            tube = 0.4 + 0.05 * math.cos(5 * around)
            c, s = math.cos(around), math.sin(around)
            positions += struct.pack("<3f", (1 + tube * math.cos(along)) * c, tube * math.sin(along),
                                     (1 + tube * math.cos(along)) * s)
            normals += struct.pack("<3f", math.cos(along) * c, math.sin(along), math.cos(along) * s)
            texcoords += struct.pack("<2f", 4 * i / COLUMNS, j / ROWS)
    pitch = COLUMNS + 1
    for j in range(ROWS):
        for i in range(COLUMNS):
            a = j * pitch + i
            indices += struct.pack("<6I", a, a + pitch, a + 1, a + 1, a + pitch, a + pitch + 1)
    return positions, normals, texcoords, indices


def write_model(path):
    """Writes the model as GLB."""
    parts = [*torus(), png(1), png(2)]
    blob, views = bytearray(), []
    for part in parts:
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(part)})
        blob += part
        blob += bytes(-len(blob) % 4)
    vertices = (COLUMNS + 1) * (ROWS + 1)
    points = list(struct.iter_unpack("<3f", parts[0]))
    low, high = ([pick(axis) for axis in zip(*points)] for pick in (min, max))
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3,
                                    "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0,
                                                "roughnessFactor": 0.5},
                       "emissiveTexture": {"index": 1}, "emissiveFactor": [0.2, 0.2, 0.2]}],
        "textures": [{"source": 0}, {"source": 1}],
        "images": [{"bufferView": 4, "mimeType": "image/png"}, {"bufferView": 5, "mimeType": "image/png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": vertices, "type": "VEC3",
             "min": low, "max": high},
            {"bufferView": 1, "componentType": 5126, "count": vertices, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": vertices, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5125, "count": 6 * COLUMNS * ROWS, "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": len(blob)}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(blob), b"BIN\0") + blob)
