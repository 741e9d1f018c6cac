"""Writes the hand-made seeds of the fuzzers of models and pictures into tests/fuzz/corpus.

usage: make_seeds.py [CORPUS_FOLDER]

Every seed is small and valid, or broken in one place, and together they touch what the importer knows of glTF.
"""

import base64
import json
import pathlib
import struct
import sys
import zlib

PROJECT = pathlib.Path(__file__).resolve().parents[2]
F32, U32, U16, U8, I8 = 5126, 5125, 5123, 5121, 5120


def png(width, height, depth, color_type, rows, extra=b"", interlace=0):
    """A PNG file from raw rows (bytes, without filter bytes)."""

    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    header = struct.pack(">IIBBBBB", width, height, depth, color_type, 0, 0, interlace)
    raw = b"".join(bytes([y % 5 if not interlace else 0]) + row for y, row in enumerate(rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra_chunks(extra, chunk) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b"")


def extra_chunks(extra, chunk):
    return b"".join(chunk(name, content) for name, content in extra) if extra else b""


def pngs():
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
    for color_type, depths in {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}.items():
        for depth in depths:
            width, height = 5, 3
            size = (width * depth * channels[color_type] + 7) // 8
            rows = [bytes((17 * x + 59 * y) % (256 if color_type != 3 else 4) for x in range(size)) for y in range(height)]
            extra = [(b"PLTE", bytes(range(48)))] if color_type == 3 and depth >= 4 else []
            if color_type == 3 and depth < 4:
                extra = [(b"PLTE", bytes(range(3 * (1 << depth))))]
            transparency = {0: b"\0\1", 2: b"\0\1\0\2\0\3", 3: b"\x80\x40"}.get(color_type)
            yield f"type{color_type}-{depth}.png", png(width, height, depth, color_type, rows, extra)
            if transparency and depth in (2, 8):
                yield f"type{color_type}-{depth}-trns.png", png(width, height, depth, color_type, rows, extra + [(b"tRNS", transparency)])
    one = [bytes([10, 20, 30, 40])]
    yield "gamma.png", png(1, 1, 8, 6, one, [(b"gAMA", struct.pack(">I", 45455)), (b"sRGB", b"\0"), (b"pHYs", b"\0\0\0\1\0\0\0\1\0")])
    yield "text.png", png(1, 1, 8, 6, one, [(b"tEXt", b"Title\0seed"), (b"zTXt", b"Title\0\0" + zlib.compress(b"seed"))])
    yield "interlaced.png", png(1, 1, 16, 6, [bytes(8)], interlace=1)
    yield "too-short.png", png(3, 3, 8, 6, one)
    yield "too-wide.png", png(5000, 1, 1, 0, [bytes(625)])


class Model:
    """A glTF document with one buffer in a data URI."""

    def __init__(self):
        self.bytes = bytearray()
        self.document = {"asset": {"version": "2.0"}, "accessors": [], "bufferViews": []}

    def view(self, content, **extra):
        self.bytes += bytes(-len(self.bytes) % 4)
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(content)} | extra)
        self.bytes += content
        return len(self.document["bufferViews"]) - 1

    def accessor(self, kind, component, numbers, **extra):
        letter = {F32: "f", U32: "I", U16: "H", U8: "B", I8: "b"}[component]
        per_element = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
        stride = extra.pop("stride", 0)
        view = self.view(struct.pack(f"<{len(numbers)}{letter}", *numbers), **({"byteStride": stride} if stride else {}))
        self.document["accessors"].append(
            {"bufferView": view, "componentType": component, "type": kind, "count": len(numbers) // per_element} | extra)
        return len(self.document["accessors"]) - 1

    def text(self):
        document = {key: value for key, value in self.document.items() if value != []}
        if self.bytes:
            uri = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
            document["buffers"] = [{"byteLength": len(self.bytes), "uri": uri}]
        return json.dumps(document, separators=(",", ":")).encode()

    def glb(self):
        document = {key: value for key, value in self.document.items() if value != []}
        document["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        binary = bytes(self.bytes) + bytes(-len(self.bytes) % 4)
        chunks = struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(binary)) + b"BIN\0" + binary
        return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def triangle(**primitive):
    model = Model()
    positions = model.accessor("VEC3", F32, [-0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0], min=[-0.5, -0.5, 0], max=[0.5, 0.5, 0])
    model.document |= {
        "meshes": [{"primitives": [{"attributes": {"POSITION": positions}} | primitive]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }
    return model


def attributes(model):
    return model.document["meshes"][0]["primitives"][0]["attributes"]


def textured():
    model = triangle(material=0)
    attributes(model)["TEXCOORD_0"] = model.accessor("VEC2", F32, [0, 0, 3, 0, 0.5, 1])
    attributes(model)["NORMAL"] = model.accessor("VEC3", F32, [0, 0, 1] * 3)
    attributes(model)["COLOR_0"] = model.accessor("VEC4", U8, [255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 9], normalized=True)
    picture = png(2, 2, 8, 6, [bytes([255, 0, 0, 255, 0, 255, 0, 128]), bytes([0, 0, 255, 0, 9, 9, 9, 255])])
    info = {"index": 0, "texCoord": 0, "extensions": {"KHR_texture_transform": {"offset": [0.1, 0], "rotation": 0.3, "scale": [2, 1]}}}
    model.document |= {
        "extensionsUsed": ["KHR_texture_transform"],
        "images": [{"uri": "data:image/png;base64," + base64.b64encode(picture).decode()}, {"bufferView": model.view(picture), "mimeType": "image/png"}],
        "samplers": [{"magFilter": 9728, "minFilter": 9987, "wrapS": 33648, "wrapT": 33071}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
        "materials": [{
            "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 1, 0.5], "baseColorTexture": info, "metallicFactor": 0.2,
                                     "roughnessFactor": 0.4, "metallicRoughnessTexture": {"index": 1}},
            "normalTexture": {"index": 1, "scale": 0.7}, "occlusionTexture": {"index": 1, "strength": 0.5},
            "emissiveTexture": {"index": 0}, "emissiveFactor": [0.1, 0.2, 0.3],
            "alphaMode": "BLEND", "doubleSided": True}],
    }
    return model


def lit():
    model = triangle(material=0)
    lights = [
        {"type": "directional", "color": [1, 0.9, 0.8], "intensity": 2},
        {"type": "point", "intensity": 30, "range": 9, "extras": {"barrido": {"intensity": -0.5, "attenuation": [1, 0.1, 0]}}},
        {"type": "spot", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.6}, "extras": {"barrido": {"spotExponent": 4}}},
    ]
    model.document |= {
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_unlit", "KHR_materials_specular"],
        "extensions": {"KHR_lights_punctual": {"lights": lights}},
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1, "zfar": 50, "aspectRatio": 1.5}},
                    {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "znear": 0, "zfar": 10}}],
        "materials": [{"alphaMode": "MASK", "alphaCutoff": 0.4, "pbrMetallicRoughness": {"roughnessFactor": 0},
                       "extensions": {"KHR_materials_specular": {"specularFactor": 0.5}},
                       "extras": {"barrido": {"ambient": [0.1, 0.1, 0.1], "diffuse": [1, 0, 0], "specular": [1, 1, 1], "shininess": 20}}},
                      {"extensions": {"KHR_materials_unlit": {}}}],
        "nodes": [{"mesh": 0, "children": [1, 2], "scale": [1, 2, 1]},
                  {"extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": [0, 0.7071068, 0, 0.7071068]},
                  {"camera": 0, "translation": [0, 0, 3]},
                  {"extensions": {"KHR_lights_punctual": {"light": 1}}, "translation": [1, 1, 1]},
                  {"extensions": {"KHR_lights_punctual": {"light": 2}}, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 2, 1]},
                  {"camera": 1, "mesh": 0}],
        "scenes": [{"nodes": [0, 3, 4], "extras": {"barrido": {"ambient": [0.1, 0.1, 0.1], "background": [0, 0, 0.2, 1],
                    "fog": {"mode": "linear", "start": 1, "end": 9, "color": [1, 1, 1]}}}}, {"nodes": [5]}],
    }
    return model


def moving():
    model = triangle(targets=[{}])
    primitive = model.document["meshes"][0]["primitives"][0]
    primitive["targets"] = [{"POSITION": model.accessor("VEC3", F32, [0, 0, 0.1] * 3), "NORMAL": model.accessor("VEC3", F32, [0, 0.1, 0] * 3)}]
    model.document["meshes"][0]["weights"] = [0.5]
    attributes(model)["JOINTS_0"] = model.accessor("VEC4", U16, [0, 1, 0, 0] * 3)
    attributes(model)["WEIGHTS_0"] = model.accessor("VEC4", F32, [0.5, 0.5, 0, 0] * 3)
    matrices = model.accessor("MAT4", F32, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] * 2)
    times = model.accessor("SCALAR", F32, [0, 0.5, 1], min=[0], max=[1])
    samplers, channels = [], []
    for path, kind, numbers, way in [
        ("translation", "VEC3", [0, 0, 0, 1, 0, 0, 0, 1, 0], "LINEAR"),
        ("rotation", "VEC4", [0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0], "STEP"),
        ("scale", "VEC3", [0.1, 0.2, 0.3] * 9, "CUBICSPLINE"),
        ("weights", "SCALAR", [0, 1, 0.5], "LINEAR"),
    ]:
        samplers.append({"input": times, "output": model.accessor(kind, F32, numbers), "interpolation": way})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": 0 if path == "weights" else 1, "path": path}})
    model.document |= {
        "nodes": [{"mesh": 0, "skin": 0}, {"children": [2]}, {"translation": [0, 0.1, 0]}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": matrices, "skeleton": 1}],
        "animations": [{"samplers": samplers, "channels": channels, "name": "wave"}],
        "scenes": [{"nodes": [0, 1]}],
    }
    return model


def sparse():
    model = triangle()
    indices, values = model.view(struct.pack("<BB", 0, 2)), model.view(struct.pack("<6f", 0, 0, 1, 0, 1, 1))
    model.document["accessors"][0]["sparse"] = {"count": 2, "indices": {"bufferView": indices, "componentType": U8}, "values": {"bufferView": values}}
    return model


def strided():
    model = triangle(indices=1)
    model.accessor("SCALAR", U8, [0, 1, 2])
    model.document["accessors"].append({"componentType": F32, "type": "VEC3", "count": 3})  # all zero
    attributes(model)["TEXCOORD_0"] = model.accessor("VEC2", U16, [0, 0, 7, 7, 65535, 0, 7, 7, 0, 65535, 7, 7], stride=8, normalized=True, count=3)
    attributes(model)["NORMAL"] = model.accessor("VEC3", I8, [0, 0, 127, 0] * 3, stride=4, normalized=True, count=3)
    model.document["extensionsRequired"] = model.document["extensionsUsed"] = ["KHR_mesh_quantization"]
    return model


def gltf_seeds():
    yield "triangle", triangle()
    for mode in range(7):
        yield f"mode{mode}", triangle(mode=mode)
    yield "textured", textured()
    yield "lit", lit()
    yield "moving", moving()
    yield "sparse", sparse()
    yield "strided", strided()
    broken = triangle(indices=0)
    yield "wrong-indices", broken
    cycle = triangle()
    cycle.document["nodes"] = [{"children": [1], "mesh": 0}, {"children": [0]}]
    yield "cycle", cycle
    outside = triangle()
    outside.document["accessors"][0]["byteOffset"] = 1 << 62
    yield "outside", outside


def main():
    corpus = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else PROJECT / "tests/fuzz/corpus")
    for target in ("gltf", "glb", "image", "validate"):
        (corpus / target).mkdir(parents=True, exist_ok=True)
    for name, model in gltf_seeds():
        (corpus / "gltf" / f"{name}.gltf").write_bytes(model.text())
        (corpus / "glb" / f"{name}.glb").write_bytes(model.glb())
        (corpus / "validate" / f"{name}.gltf").write_bytes(model.text())
    (corpus / "validate" / "textured.glb").write_bytes(textured().glb())
    for name in ("t_junction", "lost_highlight", "checker_square"):
        (corpus / "glb" / f"{name}.glb").write_bytes((PROJECT / f"models/{name}.glb").read_bytes())
    for name, content in pngs():
        (corpus / "image" / name).write_bytes(content)


if __name__ == "__main__":
    main()
