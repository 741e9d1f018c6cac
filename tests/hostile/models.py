"""Models to be broken: one glTF document that uses every part of the format which Barrido reads, made from numbers in
memory. Knows nothing of what is done to it."""

import base64
import copy
import json
import struct

import pictures

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
FORMATS = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}


class Model:
    """A document and the bytes of its one buffer."""

    def __init__(self) -> None:
        self.document = {"asset": {"version": "2.0"}}
        self.data = bytearray()

    def append(self, array: str, value) -> int:
        self.document.setdefault(array, []).append(value)
        return len(self.document[array]) - 1

    def view(self, data: bytes, **more) -> int:
        self.data += bytes(-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more}
        self.data += data
        return self.append("bufferViews", view)

    def accessor(self, numbers, component: int, kind: str, **more) -> int:
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
        data = struct.pack(f"<{len(numbers)}{FORMATS[component]}", *numbers)
        return self.append("accessors", {"bufferView": self.view(data), "componentType": component, "type": kind,
                                         "count": len(numbers) // width, **more})

    def copy(self) -> "Model":
        return copy.deepcopy(self)

    def with_buffer(self) -> dict:
        """The document with its buffer as a data URI, unless it has buffers already."""
        document = copy.deepcopy(self.document)
        if self.data and "buffers" not in document:
            uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
            document["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        return document

    def gltf(self) -> bytes:
        return json.dumps(self.with_buffer()).encode()

    def glb_parts(self) -> tuple[bytes, bytes]:
        document = copy.deepcopy(self.document)
        document.setdefault("buffers", [{"byteLength": len(self.data)}])
        text = json.dumps(document).encode()
        return text + b" " * (-len(text) % 4), bytes(self.data) + bytes(-len(self.data) % 4)

    def glb(self) -> bytes:
        text, data = self.glb_parts()
        return glb([(b"JSON", text), (b"BIN\0", data)])


def glb(chunks: list[tuple[bytes, bytes]], length: int | None = None, magic: bytes = b"glTF", version: int = 2) -> bytes:
    body = b"".join(struct.pack("<I4s", len(data), kind) + data for kind, data in chunks)
    return struct.pack("<4sII", magic, version, 12 + len(body) if length is None else length) + body


def triangle() -> Model:
    model = Model()
    model.accessor([0, 0, 0, 1, 0, 0, 0, 1, 0], FLOAT, "VEC3", min=[0, 0, 0], max=[1, 1, 0])
    model.accessor([0, 1, 2], USHORT, "SCALAR")
    model.document["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]
    model.document["nodes"] = [{"mesh": 0}]
    model.document["scenes"] = [{"nodes": [0]}]
    model.document["scene"] = 0
    return model


def textured(picture: bytes, mime: str = "image/png") -> Model:
    """A triangle with a picture from a buffer view as its base colour."""
    model = triangle()
    coordinates = model.accessor([0, 0, 1, 0, 0, 1], FLOAT, "VEC2")
    model.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = coordinates
    model.document["meshes"][0]["primitives"][0]["material"] = 0
    model.document["images"] = [{"bufferView": model.view(picture), "mimeType": mime}]
    model.document["textures"] = [{"source": 0}]
    model.document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    return model


def add_sparse(model: Model) -> int:
    """An accessor without a view of its own, two of whose elements are given."""
    indices = model.view(struct.pack("<2H", 1, 2))
    values = model.view(struct.pack("<6f", 1, 0, 0, 0, 1, 0))
    return model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": 3, "sparse": {
        "count": 2, "indices": {"bufferView": indices, "byteOffset": 0, "componentType": USHORT},
        "values": {"bufferView": values, "byteOffset": 0}}})


def add_primitives(model: Model) -> None:
    positions = add_sparse(model)
    attributes = {
        "POSITION": positions,
        "NORMAL": model.accessor([0, 0, 1] * 3, FLOAT, "VEC3"),
        "TANGENT": model.accessor([1, 0, 0, 1] * 3, FLOAT, "VEC4"),
        "TEXCOORD_0": model.accessor([0, 0, 1, 0, 0, 1], FLOAT, "VEC2"),
        "TEXCOORD_1": model.accessor([0, 0, 65535, 0, 0, 65535], USHORT, "VEC2", normalized=True),
        "COLOR_0": model.accessor([255, 255, 255, 255] * 3, UBYTE, "VEC4", normalized=True),
        "JOINTS_0": model.accessor([0, 1, 0, 0] * 3, UBYTE, "VEC4"),
        "WEIGHTS_0": model.accessor([0.5, 0.5, 0, 0] * 3, FLOAT, "VEC4"),
    }
    target = {"POSITION": model.accessor([0, 0, 0.1] * 3, FLOAT, "VEC3"),
              "NORMAL": model.accessor([0, 0, 0] * 3, FLOAT, "VEC3")}
    indices = model.accessor([0, 1, 2], UINT, "SCALAR")
    model.document["meshes"] = [
        {"weights": [0.5],
         "primitives": [{"attributes": attributes, "indices": indices, "material": 0, "mode": 4, "targets": [target]}]},
        {"primitives": [{"attributes": {"POSITION": positions}, "material": 1}]}]


def add_materials(model: Model) -> None:
    picture = model.view(pictures.png(4, 4))
    uri = "data:image/png;base64," + base64.b64encode(pictures.png(2, 2)).decode()
    model.document["images"] = [{"bufferView": picture, "mimeType": "image/png"}, {"uri": uri}]
    model.document["samplers"] = [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 33071}]
    model.document["textures"] = [{"source": 0, "sampler": 0}, {"source": 1}]
    transform = {"offset": [0.1, 0.2], "rotation": 0.5, "scale": [2, 2], "texCoord": 1}
    model.document["materials"] = [
        {"pbrMetallicRoughness": {
            "baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0.5, "roughnessFactor": 0.5,
            "baseColorTexture": {"index": 0, "texCoord": 0, "extensions": {"KHR_texture_transform": transform}},
            "metallicRoughnessTexture": {"index": 1}},
         "emissiveFactor": [0.1, 0.1, 0.1], "emissiveTexture": {"index": 1, "texCoord": 1},
         "normalTexture": {"index": 1, "scale": 1}, "occlusionTexture": {"index": 1, "strength": 1},
         "alphaMode": "MASK", "alphaCutoff": 0.5, "doubleSided": True,
         "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2}},
         "extras": {"barrido": {"ambient": [0.1, 0.1, 0.1], "diffuse": [1, 1, 1], "specular": [1, 1, 1],
                                "emission": [0, 0, 0], "shininess": 20}}},
        {"alphaMode": "BLEND", "extensions": {"KHR_materials_unlit": {}}}]


def add_nodes(model: Model) -> None:
    bind = model.accessor([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] * 2, FLOAT, "MAT4")
    model.document["skins"] = [{"inverseBindMatrices": bind, "joints": [1, 2], "skeleton": 1}]
    model.document["nodes"] = [
        {"mesh": 0, "skin": 0, "weights": [0.25]},
        {"children": [2], "translation": [0, 0.1, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]},
        {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "mesh": 1},
        {"camera": 0, "translation": [0.3, 0.3, 3]}, {"camera": 1, "translation": [0.3, 0.3, 3]},
        {"translation": [0, 0, 2], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"extensions": {"KHR_lights_punctual": {"light": 1}}}]
    model.document["scenes"] = [{"nodes": [0, 1, 3, 4, 5, 6], "extras": {"barrido": {
        "ambient": [0.1, 0.1, 0.1], "background": [0.2, 0.3, 0.4],
        "fog": {"mode": "linear", "density": 0.1, "start": 1, "end": 100, "color": [0.5, 0.5, 0.5]}}}}]
    model.document["scene"] = 0
    model.document["cameras"] = [
        {"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1, "zfar": 100, "aspectRatio": 1.5}},
        {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 2, "znear": 0.1, "zfar": 100}}]
    model.document["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "color": [1, 1, 1], "intensity": 20, "range": 50,
         "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5},
         "extras": {"barrido": {"intensity": 1, "attenuation": [1, 0, 0.1], "spotExponent": 2}}},
        {"type": "directional", "intensity": 3}]}}
    model.document["extensionsUsed"] = ["KHR_lights_punctual", "KHR_texture_transform"]


def add_animation(model: Model) -> None:
    times = model.accessor([0, 1], FLOAT, "SCALAR", min=[0], max=[1])
    moves = model.accessor([0, 0, 0, 1, 0, 0], FLOAT, "VEC3")
    turns = model.accessor([0, 0, 0, 1, 0, 0, 1, 0] * 3, FLOAT, "VEC4")
    weights = model.accessor([0, 1], FLOAT, "SCALAR")
    model.document["animations"] = [{
        "samplers": [{"input": times, "output": moves, "interpolation": "LINEAR"},
                     {"input": times, "output": turns, "interpolation": "CUBICSPLINE"},
                     {"input": times, "output": weights, "interpolation": "STEP"}],
        "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}},
                     {"sampler": 1, "target": {"node": 1, "path": "rotation"}},
                     {"sampler": 2, "target": {"node": 0, "path": "weights"}}]}]


def everything() -> Model:
    """A valid model: sparse positions, all attributes, a skin, a morph target, an animation, pictures, cameras, lights."""
    model = Model()
    add_primitives(model)
    add_materials(model)
    add_nodes(model)
    add_animation(model)
    return model
