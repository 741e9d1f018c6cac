"""Compressed meshes and pictures: streams that are whole, cut off, changed, or that promise what they do not hold. The whole
ones are the fuzzers' seeds, which the libraries' own encoders have made."""

import base64
import pathlib
import random
from collections.abc import Iterator

from calls import Case
from models import FLOAT, UINT, Model, triangle

CORPUS = pathlib.Path(__file__).resolve().parents[1] / "fuzz" / "corpus"
SMALL = ["--resolution", "64,64"]
HUGE = [2**31 - 1, 2**32 - 1, 2**53]


def case(name: str, model: Model, expect: str = "error", says: str = "") -> Case:
    return Case(name, {"model.gltf": model.gltf()}, ["render", "model.gltf", "-o", "out.png", *SMALL], expect, says)


def draco_seed(name: str) -> tuple[bytes, int, int]:
    """Stream, points, faces."""
    data = (CORPUS / "draco" / name).read_bytes()
    return data[5:], data[0] + 256 * data[1], data[2] + 256 * data[3]


def draco_model(stream: bytes, points: int, faces: int) -> Model:
    model = Model()
    view = model.view(stream)
    positions = model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": points})
    indices = model.append("accessors", {"componentType": UINT, "type": "SCALAR", "count": 3 * faces})
    model.append("meshes", {"primitives": [{
        "attributes": {"POSITION": positions}, "indices": indices,
        "extensions": {"KHR_draco_mesh_compression": {"bufferView": view, "attributes": {"POSITION": 0}}}}]})
    model.append("nodes", {"mesh": 0})
    model.append("scenes", {"nodes": [0]})
    model.document["extensionsUsed"] = ["KHR_draco_mesh_compression"]
    return model


def changed_streams(stream: bytes, seed: int) -> Iterator[tuple[str, bytes]]:
    for length in [1, 4, 5, 8, 11, 12, 13, len(stream) // 2, len(stream) - 1]:
        yield f"cut at {length}", stream[:length]
    for at in range(8, min(40, len(stream))):
        for byte in [0x00, 0x80, 0xff]:
            yield f"byte {at} {byte}", stream[:at] + bytes([byte]) + stream[at + 1:]
    chance = random.Random(seed)
    for number in range(40):
        data = bytearray(stream)
        for _ in range(chance.randrange(1, 8)):
            data[chance.randrange(len(data))] = chance.randrange(256)
        yield f"noise {number}", bytes(data)


def draco() -> Iterator[Case]:
    for seed, name in enumerate(["method0-speed5", "method1-speed0", "method1-speed5"]):
        stream, points, faces = draco_seed(name)
        yield case(f"draco {name} whole", draco_model(stream, points, faces), "fine")
        for change, data in changed_streams(stream, seed):
            yield case(f"draco {name} {change}", draco_model(data, points, faces),
                       "error" if change.startswith("cut") else "either")
        for count in HUGE:
            yield case(f"draco {name} points {count}", draco_model(stream, count, faces))
            yield case(f"draco {name} faces {count}", draco_model(stream, points, count))
        yield case(f"draco {name} one more", draco_model(stream, points, faces + 1), says="indices, but")
    # Counts of 2^31 as variable length integers, behind a header of each method.
    for method in [0, 1]:
        lie = b"DRACO" + bytes([2, 2, 1, method, 0, 0]) + b"\xff\xff\xff\xff\x07" * 20
        yield case(f"draco lying counts {method}", draco_model(lie, 100, 100))
        yield case(f"draco lying counts {method} that the accessors believe", draco_model(lie, 2**31 - 1, 700_000_000))


def meshopt_model(stream: bytes, mode: str, filter_: str, stride: int, count: int, length: int | None = None) -> Model:
    model = triangle()
    view = model.view(stream)
    compression = {**model.document["bufferViews"].pop(view), "byteStride": stride, "count": count, "mode": mode,
                   "filter": filter_}
    compressed = model.append("bufferViews", {"buffer": 1, "byteLength": stride * count if length is None else length,
                                              "extensions": {"EXT_meshopt_compression": compression}})
    accessor = model.append("accessors", {"bufferView": compressed, "componentType": FLOAT, "type": "SCALAR",
                                          "count": max(stride * count // 4, 1) if length is None else length // 4})
    model.document["meshes"][0]["primitives"][0]["targets"] = []
    model.append("animations", {"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                                "samplers": [{"input": accessor, "output": 0}]})
    model.document["extensionsUsed"] = ["EXT_meshopt_compression"]
    document = model.with_buffer()
    document["buffers"].append({"byteLength": 2**53, "extensions": {"EXT_meshopt_compression": {"fallback": True}}})
    model.document["buffers"] = document["buffers"]
    return model


def meshopt() -> Iterator[Case]:
    seeds = [("positions", "ATTRIBUTES", "NONE", 12, 120), ("exponential", "ATTRIBUTES", "EXPONENTIAL", 12, 120),
             ("octahedral", "ATTRIBUTES", "OCTAHEDRAL", 8, 120), ("quaternion", "ATTRIBUTES", "QUATERNION", 8, 120),
             ("triangles", "TRIANGLES", "NONE", 4, 90), ("indices", "INDICES", "NONE", 2, 90)]
    for seed, (name, mode, filter_, stride, count) in enumerate(seeds):
        stream = (CORPUS / "meshopt" / name).read_bytes()[3:]
        for change, data in changed_streams(stream, seed):
            # The animation that reads them is left out.
            cut = change.startswith("cut")
            yield case(f"meshopt {name} {change}", meshopt_model(data, mode, filter_, stride, count),
                       "warned" if cut else "either", "bufferViews[2]" if cut else "")
        for lie in HUGE:
            yield case(f"meshopt {name} count {lie}", meshopt_model(stream, mode, filter_, stride, lie, 1200))
        for lie in [0, 1, 3, 6, 257, 2**31]:
            yield case(f"meshopt {name} stride {lie}", meshopt_model(stream, mode, filter_, lie, count, 1200), "told", "bufferViews[2]")
    for key, value in [("buffer", 7), ("buffer", -1), ("buffer", "0"), ("byteOffset", 2**53), ("byteLength", 2**53),
                       ("mode", "WRONG"), ("mode", None), ("filter", "WRONG"), ("count", 1.5), ("byteStride", [])]:
        model = meshopt_model((CORPUS / "meshopt/positions").read_bytes()[3:], "ATTRIBUTES", "NONE", 12, 120)
        model.document["bufferViews"][-1]["extensions"]["EXT_meshopt_compression"][key] = value
        yield case(f"meshopt {key} {value}", model, "told", "bufferViews[2]")


def webp() -> Iterator[Case]:
    for seed, name in enumerate(["lossless", "lossy", "lossy-alpha"]):
        data = (CORPUS / "webp" / name).read_bytes()
        for change, broken in [("whole", data), *changed_streams(data, seed)]:
            model = triangle()
            uri = "data:image/webp;base64," + base64.b64encode(broken).decode()
            model.document["images"] = [{"uri": uri}]
            model.document["textures"] = [{"extensions": {"EXT_texture_webp": {"source": 0}}}]
            model.document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
            model.document["meshes"][0]["primitives"][0]["material"] = 0
            model.document["extensionsUsed"] = ["EXT_texture_webp"]
            yield case(f"webp {name} {change}", model, "fine" if change == "whole" else "either")


def all_cases() -> Iterator[Case]:
    for part in [draco, meshopt, webp]:
        yield from part()
