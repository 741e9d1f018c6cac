"""Containers, JSON, accessors, numbers, hierarchies: one fault a file."""

import json
import struct
from collections.abc import Callable, Iterator

from calls import Case
from models import FLOAT, UBYTE, UINT, USHORT, Model, everything, glb, triangle

SMALL = ["--resolution", "64,64"]
WRONG_FLOATS = [float("nan"), float("inf"), -float("inf"), 3.4e38, -3.4e38, 1e-45, -0.0]


def model_case(name: str, data: bytes, expect: str = "either", says: str = "", file: str = "model.gltf",
               options: list[str] | None = None) -> Case:
    return Case(name, {file: data}, ["render", file, "-o", "out.png", *(options or SMALL)], expect, says)


def changed(name: str, change: Callable[[Model], None], expect: str = "either", says: str = "",
            make: Callable[[], Model] = everything, options: list[str] | None = None) -> Case:
    model = make()
    change(model)
    return model_case(name, model.gltf(), expect, says, options=options)


def containers() -> Iterator[Case]:
    text, data = triangle().glb_parts()
    parts = [(b"JSON", text), (b"BIN\0", data)]
    whole = glb(parts)

    def case(name: str, data: bytes, expect: str = "error", says: str = "") -> Case:
        return model_case(f"glb {name}", data, expect, says, file="model.glb")

    yield case("whole", whole, "fine")
    for length in [*range(0, 28, 3), len(whole) - 1, len(whole) - len(data) - 3]:
        yield case(f"cut at {length}", whole[:length])
    for length in [0, 11, 12, 19, 20, 2**31, 2**32 - 1, len(whole) - 4]:
        yield case(f"total length {length}", glb(parts, length=length))
    for chunk, at in [("JSON", 12), ("BIN", 20 + len(text))]:
        for length in [0, 1, 3, 5, 2**31, 2**32 - 1, 2**32 - 8]:
            bytes_ = bytearray(whole)
            bytes_[at:at + 4] = struct.pack("<I", length)
            yield case(f"{chunk} length {length}", bytes(bytes_))
    yield case("unaligned JSON", glb([(b"JSON", text.rstrip() + b" " * (1 - len(text.rstrip()) % 4)), (b"BIN\0", data)]), "either")
    yield case("BIN first", glb([(b"BIN\0", data), (b"JSON", text)]))
    yield case("two BINs", glb([*parts, (b"BIN\0", data)]))
    yield case("two JSONs", glb([(b"JSON", text), *parts]))
    yield case("unknown chunk last", glb([*parts, (b"ABCD", b"1234")]), "fine")
    yield case("unknown chunk before BIN", glb([parts[0], (b"ABCD", b"1234"), parts[1]]))
    yield case("unknown chunk first", glb([(b"ABCD", b"1234"), *parts]))
    yield case("100,000 empty chunks", glb([*parts, *[(b"ABCD", b"")] * 100_000]), "either")
    yield case("version 3", glb(parts, version=3))
    yield case("magic of a PNG", glb(parts, magic=b"\x89PNG"))
    yield case("bytes behind", whole + b"x" * 100, "fine")
    for size in [1, 5, 100]:
        yield case(f"{size} zero bytes", bytes(size))


def deep(opening: bytes, closing: bytes, depth: int) -> bytes:
    return opening * depth + closing * depth


def texts() -> Iterator[Case]:
    start = triangle().gltf()[:-1]

    def with_value(value: bytes) -> bytes:
        return start + b', "extras": ' + value + b"}"

    for depth in [60, 65, 1000, 300_000]:
        expect = "fine" if depth < 64 else "error"
        yield model_case(f"arrays {depth} deep", with_value(deep(b"[", b"]", depth)), expect)
        yield model_case(f"objects {depth} deep", with_value(deep(b'{"a":', b"}", depth).replace(b":}", b":0}")), expect)
    yield model_case("brackets never closed", b"{" * 500_000, "error")
    yield model_case("brackets never opened", with_value(b"]" * 500_000), "error")
    yield model_case("brackets in a string", with_value(b'"' + b"[" * 100_000 + b'"'), "fine")
    yield model_case("a string that does not end", with_value(b'"' + b"x" * 100_000)[:-1], "error")
    yield model_case("a million digits", with_value(b"1" * 1_000_000), "either")
    yield model_case("a million digits behind the point", with_value(b"0." + b"1" * 1_000_000), "either")
    yield model_case("an exponent of a million digits", with_value(b"1e" + b"9" * 1_000_000), "either")
    yield model_case("a string of 20 MB", with_value(b'"' + b"x" * 20_000_000 + b'"'), "either")
    yield model_case("a key of 5 MB", with_value(b'{"' + b"x" * 5_000_000 + b'":0}'), "either")
    yield model_case("a name of 5 MB", start + b', "nodes": [{"name": "' + b"x" * 5_000_000 + b'"}]}', "either")
    yield model_case("asset twice", start + b', "asset": {"version": "2.0"}}', "either")
    yield model_case("asset twice, the second of another type", start + b', "asset": []}', "error")
    yield model_case("accessors twice", start + b', "accessors": [{"count": -1}]}', "error")
    yield model_case("meshes twice, empty", start + b', "meshes": []}', "error")
    yield model_case("behind the end", start + b"} {}", "error")
    for name, bad in [("alone", b"\x80"), ("cut", b"\xe2\x82"), ("overlong", b"\xc0\xaf"), ("surrogate", b"\xed\xa0\x80"),
                      ("beyond", b"\xf5\x80\x80\x80"), ("zero", b"\x00")]:
        yield model_case(f"UTF-8 {name}", with_value(b'"' + bad + b'"'), "error")
        yield model_case(f"UTF-8 {name} as a key", with_value(b'{"' + bad + b'":0}'), "error")
    yield model_case("half a surrogate pair", with_value(b'"\\ud800"'), "either")
    yield model_case("a byte order mark", b"\xef\xbb\xbf" + triangle().gltf(), "fine")
    yield model_case("UTF-16", triangle().gltf().decode().encode("utf-16"), "error")
    for literal in [b"NaN", b"Infinity", b"-Infinity", b"nan", b"0x10", b"01", b"1.", b".5", b"+1", b"'x'", b"// x\n1", b"1,"]:
        yield model_case(f"literal {literal.decode().strip()}", with_value(literal), "error")
    controls = start + b', "extensionsRequired": ["\\u001b[31m\\nbarrido: a line of its own\\u0007"]}'
    yield model_case("escapes in a name that is told", controls, "error", "is not supported")
    yield model_case("a long name that is told", start + b', "extensionsRequired": ["' + b"x" * 100_000 + b'"]}', "error")


def floats() -> Iterator[Case]:
    """Numbers that are none in every accessor of floats."""
    model = everything()
    for index, accessor in enumerate(model.document["accessors"]):
        if accessor["componentType"] != FLOAT:
            continue
        view = accessor.get("bufferView", accessor.get("sparse", {}).get("values", {}).get("bufferView"))
        begin = model.document["bufferViews"][view]["byteOffset"]
        for number in WRONG_FLOATS:
            broken = everything()
            for element in range(0, model.document["bufferViews"][view]["byteLength"] // 4, 2):
                broken.data[begin + 4 * element:begin + 4 * element + 4] = struct.pack("<f", number)
            yield model_case(f"{number} in accessor {index}", broken.gltf(), options=[*SMALL, "--time", "0.3"])


def accessors() -> Iterator[Case]:
    """Views, strides, types and counts that do not fit, at every accessor."""
    count = len(everything().document["accessors"])
    faults = {
        "count 2^53": {"count": 2**53}, "count 2^31": {"count": 2**31}, "count 2^32 / 12 + 1": {"count": 357913942},
        "count 0": {"count": 0}, "offset 2^63": {"byteOffset": 2**63}, "offset -1": {"byteOffset": -1},
        "offset 2^62": {"byteOffset": 2**62}, "no view, count 10^9": {"bufferView": None, "count": 10**9},
        "no view, count 5 10^7": {"bufferView": None, "count": 5 * 10**7},
        "type VEC9": {"type": "VEC9"}, "type MAT2": {"type": "MAT2"}, "component 5126.5": {"componentType": 5126.5},
        "component 5124": {"componentType": 5124}, "component 5131": {"componentType": 5131}, "view -1": {"bufferView": -1},
        "sparse 2^31": {"sparse": {"count": 2**31, "indices": {"bufferView": 0, "componentType": UINT}, "values": {"bufferView": 1}}},
    }
    for index in range(count):
        for name, fault in faults.items():
            def change(model: Model, index: int = index, fault: dict = fault) -> None:
                accessor = model.document["accessors"][index]
                accessor.update(fault)
                if accessor.get("bufferView", 0) is None:
                    del accessor["bufferView"]

            if index % 4 == 0 or name.startswith(("no view", "count 2^32")):
                yield changed(f"accessor {index}: {name}", change)


def sparse() -> Iterator[Case]:
    for name, indices, says in [("beyond", [1, 3], ""), ("descending", [2, 1], "ascend"), ("twice", [1, 1], "ascend"),
                                ("the largest", [0, 65535], "")]:
        def change(model: Model, indices: list[int] = indices) -> None:
            begin = model.document["bufferViews"][0]["byteOffset"]
            model.data[begin:begin + 4] = struct.pack("<2H", *indices)

        yield changed(f"sparse indices {name}", change, "error", says)

    def set_sparse(**more: dict) -> Callable[[Model], None]:
        def change(model: Model) -> None:
            part = model.document["accessors"][0]["sparse"]
            for key, value in more.items():
                part[key] = {**part[key], **value} if isinstance(value, dict) else value
        return change

    for name, more in [("values offset 2^31 - 4", {"values": {"byteOffset": 2**31 - 4}}), ("indices offset", {"indices": {"byteOffset": 2}}),
                       ("values view", {"values": {"bufferView": 99}}), ("count 4", {"count": 4}), ("count 0", {"count": 0}),
                       ("signed indices", {"indices": {"componentType": 5122}}), ("float indices", {"indices": {"componentType": FLOAT}}),
                       ("byte indices", {"indices": {"componentType": UBYTE}})]:
        yield changed(f"sparse {name}", set_sparse(**more), "error")


def indices() -> Iterator[Case]:
    for component, numbers in [(UBYTE, [0, 1, 255]), (USHORT, [0, 1, 65535]), (UINT, [0, 1, 2**32 - 1]), (UINT, [3, 0, 1]), (UINT, [0, 1, 2**31])]:
        for mode in range(7):
            def change(model: Model, component: int = component, numbers: list[int] = numbers, mode: int = mode) -> None:
                part = model.document["meshes"][0]["primitives"][0]
                part["indices"] = model.accessor(numbers, component, "SCALAR")
                part["mode"] = mode

            yield changed(f"indices {numbers} mode {mode}", change, "error", "there are only 3 vertices", make=triangle)
    for numbers in [[0], [0, 1], [0, 1, 2, 0], [0, 0, 0], [2, 2, 1, 1, 0, 0, 0]]:
        for mode in range(7):
            def change_few(model: Model, numbers: list[int] = numbers, mode: int = mode) -> None:
                part = model.document["meshes"][0]["primitives"][0]
                part["indices"] = model.accessor(numbers, UBYTE, "SCALAR")
                part["mode"] = mode

            yield changed(f"{len(numbers)} indices mode {mode}", change_few, "fine", make=triangle)
    for component in [USHORT, UBYTE]:
        def change_joints(model: Model, component: int = component) -> None:
            attributes = model.document["meshes"][0]["primitives"][0]["attributes"]
            attributes["JOINTS_0"] = model.accessor([2, 0, 0, 0] * 3, component, "VEC4")

        yield changed(f"joints beyond the skin {component}", change_joints, "error", "has only 2")


def hierarchies() -> Iterator[Case]:
    def nodes(name: str, children: dict[int, list[int]], roots: list[int], expect: str = "error") -> Case:
        def change(model: Model) -> None:
            count = max([*children, *roots, *(child for list_ in children.values() for child in list_)]) + 1
            model.document["nodes"] = [{"mesh": 0, **({"children": children[i]} if i in children else {})} for i in range(count)]
            model.document["scenes"] = [{"nodes": roots}]

        return changed(f"nodes: {name}", change, expect, make=triangle)

    yield nodes("a chain of 20,000", {i: [i + 1] for i in range(20_000)}, [0], "fine")
    yield nodes("a star of 20,000", {0: list(range(1, 20_000))}, [0], "fine")
    yield nodes("a cycle beside the scene", {1: [2], 2: [3], 3: [1]}, [0])
    yield nodes("a cycle below the root", {0: [1], 1: [2], 2: [1]}, [0])
    yield nodes("a diamond", {0: [1, 2], 1: [3], 2: [3]}, [0])
    yield nodes("the same child twice", {0: [1, 1]}, [0])
    yield nodes("a root twice", {}, [0, 0], "either")
    yield nodes("a root that has a parent", {0: [1]}, [0, 1], "warned")
    yield nodes("itself", {0: [0]}, [0])
    yield nodes("itself, beside the scene", {1: [1]}, [0])

    def joints(model: Model) -> None:
        model.document["skins"][0]["joints"] = [1, 1]

    yield changed("skin: a joint twice", joints)

    def unreached(model: Model) -> None:
        model.document["scenes"][0]["nodes"] = [0]

    yield changed("skin: joints beside the scene", unreached)
    for key, value in [("mesh", 2), ("skin", 1), ("camera", 2), ("children", [99]), ("children", ["1"])]:
        yield changed(f"node 0: {key} {value}", lambda model, key=key, value=value: model.document["nodes"][0].update({key: value}), "error")


def all_cases() -> Iterator[Case]:
    for part in [containers, texts, floats, accessors, sparse, indices, hierarchies]:
        yield from part()
