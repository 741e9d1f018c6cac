#!/usr/bin/env python3
"""Writes the glTF scenes and environment pictures of this folder: one feature of the format each, as small as it can be seen.

usage: make_scenes.py [FOLDER]      default: the folder of this file

The files are committed, for the last bit of a sine may differ between machines. Buffers and pictures stand in the files as
data URIs.
"""
import base64
import json
import math
import pathlib
import struct
import sys
import zlib

FLOAT, USHORT, SHORT, UBYTE, BYTE = 5126, 5123, 5122, 5121, 5120
CODE = {FLOAT: "f", USHORT: "H", SHORT: "h", UBYTE: "B", BYTE: "b"}
KIND = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def png(width, height, rule):
    """RGBA; rule(x, y) gives bytes, y from the top."""
    rows = b"".join(b"\0" + b"".join(bytes(rule(x, y)) for x in range(width)) for y in range(height))
    chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def letter(x, y):
    """An F: turned or mirrored is seen at once."""
    ink = (4 <= x < 7 and 2 <= y < 14) or (4 <= x < 12 and 2 <= y < 5) or (4 <= x < 10 and 7 <= y < 10)
    if ink:
        return (255, 255, 255, 255)
    return (190 if x < 8 else 30, 50 if y < 8 else 150, 40 if x < 8 else 150, 255)


def data_uri(kind, data):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


class Scene:
    def __init__(self):
        self.root = {"asset": {"version": "2.0", "generator": "make_scenes.py"}, "scene": 0, "scenes": [{"nodes": []}],
                     "nodes": [], "meshes": []}
        self.binary = b""

    def add(self, array, element):
        self.root.setdefault(array, []).append(element)
        return len(self.root[array]) - 1

    def uses(self, *extensions):
        self.root.setdefault("extensionsUsed", []).extend(extensions)

    def view(self, data, stride=0):
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if stride:
            view["byteStride"] = stride
        self.binary += data
        return self.add("bufferViews", view)

    def accessor(self, rows, kind=FLOAT, normalized=False, bounds=False):
        rows = [r if isinstance(r, (tuple, list)) else (r,) for r in rows]
        size = len(rows[0])
        data = b""
        for row in rows:
            data += struct.pack(f"<{size}{CODE[kind]}", *row)
            data += b"\0" * (-len(data) % 4 if kind != USHORT or size > 1 else 0)
        stride = len(data) // len(rows)
        packed = struct.calcsize(f"<{size}{CODE[kind]}") == stride
        accessor = {"bufferView": self.view(data, 0 if packed else stride), "componentType": kind, "count": len(rows),
                    "type": KIND[size]}
        if normalized:
            accessor["normalized"] = True
        if bounds:
            # What is stored are floats of 32 bits.
            stored = [struct.unpack(f"<{size}{CODE[kind]}", struct.pack(f"<{size}{CODE[kind]}", *row)) for row in rows]
            accessor["min"] = [min(column) for column in zip(*stored)]
            accessor["max"] = [max(column) for column in zip(*stored)]
        return self.add("accessors", accessor)

    def mesh(self, positions, normals=None, texcoords=None, indices=None, material=None, **more):
        primitive = {"attributes": {"POSITION": self.accessor(positions, bounds=True)}}
        if normals:
            primitive["attributes"]["NORMAL"] = self.accessor(normals)
        if texcoords:
            primitive["attributes"]["TEXCOORD_0"] = self.accessor(texcoords)
        if indices:
            primitive["indices"] = self.accessor(indices, USHORT)
        if material is not None:
            primitive["material"] = material
        primitive.update(more)
        return self.add("meshes", {"primitives": [primitive]})

    def node(self, scene=0, **node):
        index = self.add("nodes", node)
        if scene is not None:
            self.root["scenes"][scene]["nodes"].append(index)
        return index

    def texture(self, rule=letter, side=16, sampler=None):
        image = self.add("images", {"uri": data_uri("image/png", png(side, side, rule))})
        texture = {"source": image}
        if sampler:
            texture["sampler"] = self.add("samplers", sampler)
        return self.add("textures", texture)

    def material(self, color=(0.8, 0.8, 0.8, 1), metallic=0.0, roughness=0.6, texture=None, **more):
        pbr = {"baseColorFactor": list(color), "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            pbr["baseColorTexture"] = texture if isinstance(texture, dict) else {"index": texture}
        return self.add("materials", {"pbrMetallicRoughness": pbr, **more})

    def camera(self, distance=4.0, height=0.0, fov=0.7):
        camera = self.add("cameras", {"type": "perspective", "perspective": {"yfov": fov, "znear": 0.1, "zfar": 100}})
        return self.node(camera=camera, translation=[0, height, distance])

    def write(self, path):
        self.root["buffers"] = [{"uri": data_uri("application/octet-stream", self.binary), "byteLength": len(self.binary)}]
        path.write_text(json.dumps(self.root, separators=(",", ":")) + "\n")


def square(half=1.0, z=0.0):
    return [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]


SQUARE_NORMALS = [(0, 0, 1)] * 4
SQUARE_TEXCOORDS = [(0, 1), (1, 1), (1, 0), (0, 0)]
SQUARE_INDICES = [0, 1, 2, 0, 2, 3]


def add_square(s, material, half=1.0, **node):
    mesh = s.mesh(square(half), SQUARE_NORMALS, SQUARE_TEXCOORDS, SQUARE_INDICES, material)
    return s.node(mesh=mesh, **node)


def ball(slices, stacks, radius=1.0):
    points = []
    for j in range(stacks + 1):
        ring, y = math.sin(math.pi * j / stacks), math.cos(math.pi * j / stacks)
        for i in range(slices + 1):  # where the surface closes, places are equal
            angle = 2 * math.pi * (i % slices) / slices
            points.append(tuple(round(c, 9) + 0.0 for c in (ring * math.sin(angle), y, ring * math.cos(angle))))
    indices = []
    for j in range(stacks):
        for i in range(slices):
            a, b = j * (slices + 1) + i, (j + 1) * (slices + 1) + i
            indices += [a, b, b + 1, a, b + 1, a + 1]
    return [tuple(radius * c for c in p) for p in points], points, indices


BOX = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
BOX_INDICES = [4, 5, 7, 4, 7, 6, 1, 0, 2, 1, 2, 3, 5, 1, 3, 5, 3, 7, 0, 4, 6, 0, 6, 2, 6, 7, 3, 6, 3, 2, 0, 1, 5, 0, 5, 4]


def alpha_modes(s):
    fading = s.texture(lambda x, y: (250, 180, 60, 255 * x // 15), sampler={"wrapS": 33071, "wrapT": 33071})
    back = s.material((0.2, 0.4, 0.8, 1))
    add_square(s, back, 0.35, scale=[8, 1, 1], translation=[0, 0, -0.5])
    for i, mode in enumerate(["OPAQUE", "MASK", "BLEND"]):
        more = {"alphaCutoff": 0.4} if mode == "MASK" else {}
        add_square(s, s.material((1, 1, 1, 1), texture=fading, alphaMode=mode, **more), 0.6, translation=[1.4 * i - 1.4, 0, 0])
    s.camera(4.5)


def transparent_order(s):
    for i, color in enumerate([(0.9, 0.2, 0.2, 0.5), (0.2, 0.8, 0.3, 0.5), (0.2, 0.3, 0.9, 0.5)]):
        add_square(s, s.material(color, alphaMode="BLEND"), 0.7, translation=[0.4 * i - 0.4, 0.3 * i - 0.3, 0.5 - 0.5 * i])
    s.camera()


def crossing_panes(s):
    """Each pane lies partly before and partly behind both others."""
    for i, color in enumerate([(0.9, 0.2, 0.2, 0.6), (0.2, 0.8, 0.3, 0.6), (0.2, 0.3, 0.9, 0.6)]):
        turn = math.radians(20 + 60 * i)
        add_square(s, s.material(color, alphaMode="BLEND", doubleSided=True), 1.0,
                   rotation=[0, math.sin(turn / 2), 0, math.cos(turn / 2)])
    s.camera()


def vertex_colors(s):
    mesh = s.mesh(square(), SQUARE_NORMALS, None, SQUARE_INDICES, s.material((1, 1, 1, 1), alphaMode="BLEND"))
    colors = [(255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (255, 255, 255, 0)]
    s.root["meshes"][mesh]["primitives"][0]["attributes"]["COLOR_0"] = s.accessor(colors, UBYTE, True)
    s.node(mesh=mesh)
    s.camera()


def skin(s):
    rows = 12
    positions, joints, weights, normals = [], [], [], []
    for j in range(rows + 1):
        y = 2.0 * j / rows
        w = min(max((y - 0.6) / 0.8, 0.0), 1.0)
        for i in range(13):
            a = 2 * math.pi * i / 12
            positions.append((0.3 * math.sin(a), y, 0.3 * math.cos(a)))
            normals.append((math.sin(a), 0, math.cos(a)))
            joints.append((0, 1, 0, 0))
            weights.append((1 - w, w, 0, 0))
    indices = []
    for j in range(rows):
        for i in range(12):
            a = 13 * j + i
            indices += [a, a + 1, a + 14, a, a + 14, a + 13]
    mesh = s.mesh(positions, normals, None, indices, s.material((0.3, 0.6, 0.9, 1), doubleSided=True))
    attributes = s.root["meshes"][mesh]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = s.accessor(joints, UBYTE)
    attributes["WEIGHTS_0"] = s.accessor(weights)
    upper = s.node(None, translation=[0, 1, 0])
    lower = s.node(translation=[0, 0, 0], children=[upper])
    bind = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1), (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1)]
    s.add("skins", {"joints": [lower, upper], "inverseBindMatrices": s.accessor(bind)})
    s.node(mesh=mesh, skin=0)
    turn = [(0, 0, 0, 1), (0, 0, math.sin(math.pi / 4), math.cos(math.pi / 4))]
    animate(s, upper, "rotation", [0, 1], turn)
    s.camera(4.5, 1.0)


def animate(s, node, path, times, values, interpolation="LINEAR"):
    if "animations" not in s.root:
        s.add("animations", {"channels": [], "samplers": []})
    animation = s.root["animations"][0]
    sampler = {"input": s.accessor(times, bounds=True), "output": s.accessor(values), "interpolation": interpolation}
    animation["samplers"].append(sampler)
    animation["channels"].append({"sampler": len(animation["samplers"]) - 1, "target": {"node": node, "path": path}})


def morph(s):
    positions, normals, indices = ball(20, 12)
    mesh = s.mesh(positions, normals, None, indices, s.material((0.8, 0.6, 0.3, 1)))
    bulge = [(0.8 * x * max(0, y), 0, 0.8 * z * max(0, y)) for x, y, z in positions]
    stretch = [(0, -0.6 * y if y < 0 else 0, 0) for x, y, z in positions]
    s.root["meshes"][mesh]["primitives"][0]["targets"] = [{"POSITION": s.accessor(d, bounds=True)} for d in (bulge, stretch)]
    s.root["meshes"][mesh]["weights"] = [0, 0]
    node = s.node(mesh=mesh)
    animate(s, node, "weights", [0, 1], [0, 0, 1, -1])
    s.camera(4.5)


def interpolations(s):
    mesh = s.mesh(BOX, None, None, BOX_INDICES, s.material((0.8, 0.3, 0.3, 1)))
    for i, kind in enumerate(["STEP", "LINEAR", "CUBICSPLINE"]):
        y = 1.2 - 1.2 * i
        node = s.node(mesh=mesh, scale=[0.3, 0.3, 0.3])
        points = [(-2, y, 0), (2, y, 0)]
        if kind == "CUBICSPLINE":
            points = [(0, 0, 0), points[0], (0, 0, 0), (0, 0, 0), points[1], (0, 0, 0)]
        animate(s, node, "translation", [0, 1], points, kind)
    s.camera(6)


def cameras(s):
    mesh = s.mesh(BOX, None, None, BOX_INDICES, s.material((0.4, 0.7, 0.4, 1)))
    s.node(mesh=mesh)
    turn = [-0.1913, 0.3535, 0.0761, 0.9125]
    eye = [3.2, 2.1, 3.4]
    s.node(camera=s.add("cameras", {"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1, "zfar": 50}}),
           translation=eye, rotation=unit(turn))
    s.node(camera=s.add("cameras", {"type": "orthographic", "orthographic": {"xmag": 2.4, "ymag": 2.0, "znear": 0.1, "zfar": 50}}),
           translation=eye, rotation=unit(turn))


def moving_properties(s):
    """A colour, a texture's place, a light's cone and a camera's angle move (KHR_animation_pointer)."""
    s.uses("KHR_animation_pointer", "KHR_texture_transform", "KHR_lights_punctual")
    add_square(s, s.material((1, 0, 0, 1)), 0.8, translation=[-1, 0, 0])
    turned = {"index": s.texture(), "extensions": {"KHR_texture_transform": {"scale": [0.5, 0.5]}}}
    add_square(s, s.material((1, 1, 1, 1), texture=turned), 0.8, translation=[1, 0, 0])
    spot = {"type": "spot", "intensity": 30, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}
    s.root["extensions"] = {"KHR_lights_punctual": {"lights": [spot]}}
    s.node(translation=[0, 0, 3], extensions={"KHR_lights_punctual": {"light": 0}})
    s.camera(4)
    animation = {"samplers": [], "channels": []}
    for pointer, values in [("/materials/0/pbrMetallicRoughness/baseColorFactor", [(1, 0, 0, 1), (0, 0, 1, 1)]),
                            ("/materials/1/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset",
                             [(0, 0), (1, 0.5)]),
                            ("/materials/1/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/rotation",
                             [0.0, 1.0]),
                            ("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", [0.2, 1.2]),
                            ("/cameras/0/perspective/yfov", [0.6, 1.0])]:
        animation["channels"].append({"sampler": len(animation["samplers"]), "target": {
            "path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": pointer}}}})
        animation["samplers"].append({"input": s.accessor([0.0, 1.0], bounds=True), "output": s.accessor(values)})
    s.add("animations", animation)


def unit(q):
    length = math.sqrt(sum(c * c for c in q))
    return [c / length for c in q]


def quantization(s):
    s.uses("KHR_mesh_quantization")
    s.root["extensionsRequired"] = ["KHR_mesh_quantization"]
    positions, normals, indices = ball(20, 12)
    quantized = [tuple(round(c * 32767) for c in p) for p in positions]
    attributes = {"POSITION": s.accessor(quantized, SHORT, True, True),
                  "NORMAL": s.accessor([tuple(round(c * 127) for c in n) for n in normals], BYTE, True),
                  "TEXCOORD_0": s.accessor([(i % 21 * 255 // 20, i // 21 * 255 // 12) for i in range(len(positions))], UBYTE, True)}
    material = s.material((1, 1, 1, 1), texture=s.texture())
    s.add("meshes", {"primitives": [{"attributes": attributes, "indices": s.accessor(indices, USHORT), "material": material}]})
    s.node(mesh=0, scale=[1.2, 1.2, 1.2], rotation=[0, 1, 0, 0])
    s.camera()


def texture_transform(s):
    s.uses("KHR_texture_transform")
    texture = s.texture()
    for i, transform in enumerate([{}, {"offset": [0.25, 0]}, {"rotation": 0.5}, {"scale": [2, 3]},
                                   {"offset": [0.5, 0.5], "rotation": 1.5707964, "scale": [1.5, 1.5]}]):
        info = {"index": texture, "extensions": {"KHR_texture_transform": transform}}
        add_square(s, s.material((1, 1, 1, 1), texture=info), 0.65, translation=[1.4 * (i % 3) - 1.4, 0.7 - 1.4 * (i // 3), 0])
    s.camera(4.6)


def sparse(s):
    positions = [(x / 4 - 1, y / 4 - 1, 0) for y in range(9) for x in range(9)]
    indices = [a + d for y in range(8) for x in range(8) for a in [9 * y + x] for d in (0, 1, 10, 0, 10, 9)]
    mesh = s.mesh(positions, None, None, indices, s.material((0.7, 0.7, 0.8, 1), doubleSided=True))
    peaks = [20, 40, 60]
    moved = [(positions[i][0], positions[i][1], 0.7) for i in peaks]
    accessor = s.root["accessors"][s.root["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"]]
    accessor["sparse"] = {"count": 3,
                          "indices": {"bufferView": s.view(struct.pack("<3H", *peaks)), "componentType": USHORT},
                          "values": {"bufferView": s.view(struct.pack("<9f", *[c for p in moved for c in p]))}}
    accessor["max"][2] = struct.unpack("<f", struct.pack("<f", 0.7))[0]
    s.node(mesh=mesh, rotation=unit([-0.4, 0, 0, 0.9]))
    s.camera()


def unlit(s):
    s.uses("KHR_materials_unlit")
    positions, normals, indices = ball(20, 12, 0.9)
    for i in range(2):
        more = {"extensions": {"KHR_materials_unlit": {}}} if i == 1 else {}
        mesh = s.mesh(positions, normals, None, indices, s.material((0.8, 0.4, 0.2, 1), **more))
        s.node(mesh=mesh, translation=[2 * i - 1, 0, 0])
    s.camera(5)


def double_sided(s):
    for i in range(4):
        material = s.material((0.9, 0.6, 0.3, 1), doubleSided=i % 2 == 1)
        turn = [0, 0.9428, 0, 0.3333] if i > 1 else [0, 0.2, 0, 0.98]
        add_square(s, material, 0.6, translation=[1.4 * (i % 2) - 0.7, 0.7 - 1.4 * (i // 2), 0], rotation=unit(turn))
    s.camera(4.6)


def primitive_modes(s):
    s.uses("KHR_materials_unlit")
    material = s.material((0.9, 0.8, 0.3, 1), extensions={"KHR_materials_unlit": {}}, doubleSided=True)
    points = [(-0.5, -0.4, 0), (-0.5, 0.4, 0), (0, -0.4, 0), (0, 0.4, 0), (0.5, -0.4, 0), (0.5, 0.4, 0)]
    for mode in range(7):
        corners = points if mode != 6 else [points[0], points[2], points[4], points[5], points[3], points[1]]
        s.node(mesh=s.mesh(corners, material=material, mode=mode), translation=[1.3 * (mode % 4) - 1.95, 0.6 - 1.2 * (mode // 4), 0])
    s.camera(6)


def punctual_lights(s):
    s.uses("KHR_lights_punctual")
    lights = [{"type": "directional", "color": [0.3, 0.3, 0.4], "intensity": 1},
              {"type": "point", "color": [1, 0.4, 0.2], "intensity": 1.5, "range": 2},
              {"type": "spot", "color": [0.4, 1, 0.5], "intensity": 4,
               "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.45}}]
    s.root["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
    add_square(s, s.material((0.9, 0.9, 0.9, 1), roughness=0.9), 1.5)
    for i, place in enumerate([[0, 0, 1], [-0.8, 0.4, 0.5], [0.7, -0.2, 1.5]]):
        s.node(translation=place, extensions={"KHR_lights_punctual": {"light": i}})
    s.camera(4.2)


def second_texcoords(s):
    texture = s.texture()
    for i in range(2):
        mesh = s.mesh(square(0.9), SQUARE_NORMALS, SQUARE_TEXCOORDS, SQUARE_INDICES,
                      s.material((1, 1, 1, 1), texture={"index": texture, "texCoord": i}))
        turned = [(3 * v, 3 * u) for u, v in SQUARE_TEXCOORDS]
        s.root["meshes"][mesh]["primitives"][0]["attributes"]["TEXCOORD_1"] = s.accessor(turned)
        s.node(mesh=mesh, translation=[2 * i - 1, 0, 0])
    s.camera(4.4)


def mirrored_node(s):
    texture = s.texture()
    for i in range(2):
        add_square(s, s.material((1, 1, 1, 1), texture=texture), 0.9, translation=[2 * i - 1, 0, 0], scale=[1 - 2 * i, 1, 1],
                   rotation=unit([0, 0.15, 0, 0.98]))
    s.camera(4.4)


def samplers(s):
    """Repeat, mirror and clamp; nearest above, linear below."""
    for i in range(6):
        wrap = [10497, 33648, 33071][i % 3]
        mag, low = [(9728, 9728), (9729, 9987)][i // 3]
        texture = s.texture(sampler={"wrapS": wrap, "wrapT": wrap, "magFilter": mag, "minFilter": low})
        mesh = s.mesh(square(0.65), SQUARE_NORMALS, [(3 * u - 1, 3 * v - 1) for u, v in SQUARE_TEXCOORDS], SQUARE_INDICES,
                      s.material((1, 1, 1, 1), texture=texture))
        s.node(mesh=mesh, translation=[1.4 * (i % 3) - 1.4, 0.7 - 1.4 * (i // 3), 0])
    s.camera(4.6)


def emission(s):
    glow = s.texture(lambda x, y: (255, 160, 0, 255) if (x // 4 + y // 4) % 2 else (0, 0, 0, 255))
    positions, normals, indices = ball(20, 12)
    texcoords = [(i % 21 / 10, i // 21 / 12) for i in range(len(positions))]
    material = s.material((0.2, 0.3, 0.6, 1), emissiveFactor=[0.8, 0.8, 0.8], emissiveTexture={"index": glow})
    s.node(mesh=s.mesh(positions, normals, texcoords, indices, material))
    s.camera()


def metal_and_roughness(s):
    """Metalness grows upwards, roughness to the right."""
    positions, normals, indices = ball(20, 12, 0.5)
    for i in range(9):
        material = s.material((0.9, 0.6, 0.3, 1), metallic=i // 3 / 2, roughness=0.1 + 0.4 * (i % 3))
        if i == 0:
            s.mesh(positions, normals, None, indices, material)
        else:  # the same vertices
            s.add("meshes", {"primitives": [{**s.root["meshes"][0]["primitives"][0], "material": material}]})
        s.node(mesh=i, translation=[1.1 * (i % 3) - 1.1, 1.1 * (i // 3) - 1.1, 0])
    s.camera(5)


def no_normals(s):
    s.node(mesh=s.mesh(BOX, None, None, BOX_INDICES, s.material((0.7, 0.5, 0.4, 1))), scale=[0.6, 0.6, 0.6],
           translation=[-1, 0, 0], rotation=unit([0.25, 0.35, 0, 0.9]))
    positions, _, indices = ball(12, 8, 0.9)
    s.node(mesh=s.mesh(positions, None, None, indices, s.material((0.5, 0.6, 0.8, 1))), translation=[1, 0, 0])
    s.camera(5)


def two_scenes(s):
    s.root["scenes"].append({"nodes": []})
    s.node(0, mesh=s.mesh(BOX, None, None, BOX_INDICES, s.material((0.8, 0.3, 0.3, 1))))
    positions, normals, indices = ball(16, 10)
    s.node(1, mesh=s.mesh(positions, normals, None, indices, s.material((0.3, 0.4, 0.8, 1))))


def extras(s):
    """The values of the formulas themselves: two lights, one negative, ambient light, fog, background."""
    s.uses("KHR_lights_punctual")
    lights = [{"type": "point", "extras": {"barrido": {"intensity": 3, "attenuation": [2, 1, 0]}}},
              {"type": "point", "color": [0, 0, 1], "extras": {"barrido": {"intensity": -0.8, "attenuation": [1, 0, 0]}}}]
    s.root["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
    exact = {"ambient": [0.1, 0.1, 0.3], "diffuse": [0.6, 0.6, 0.6], "specular": [0.5, 0.5, 0.5], "shininess": 40}
    positions, normals, indices = ball(24, 16)
    mesh = s.mesh(positions, normals, None, indices, s.material(extras={"barrido": exact}))
    s.node(mesh=mesh, translation=[-0.7, 0, 0])
    s.node(mesh=mesh, translation=[0.9, 0, -2.5])
    s.node(translation=[-3, 3, 3], extensions={"KHR_lights_punctual": {"light": 0}})
    s.node(translation=[3, 2, 2], extensions={"KHR_lights_punctual": {"light": 1}})
    fog = {"mode": "linear", "start": 3, "end": 9, "color": [0.6, 0.65, 0.7]}
    s.root["scenes"][0]["extras"] = {"barrido": {"ambient": [0.5, 0.5, 0.5], "background": [0.6, 0.65, 0.7], "fog": fog}}
    s.camera(4.6)


def mirror_ball(s):
    positions, normals, indices = ball(32, 20)
    s.node(mesh=s.mesh(positions, normals, None, indices, s.material((1, 1, 1, 1), metallic=1.0, roughness=0.05)))
    s.camera(4)


FACES = {"px": (200, 40, 40), "nx": (40, 180, 180), "py": (40, 180, 40), "ny": (180, 40, 180), "pz": (40, 60, 210),
         "nz": (210, 180, 40)}


def face_texel(face, x, y, side):
    """Its colour, darker in squares, a white corner at the upper left."""
    if x < side // 4 and y < side // 4:
        return (255, 255, 255, 255)
    shade = 1.0 if (x // 4 + y // 4) % 2 == 0 else 0.7
    return tuple(round(c * shade) for c in FACES[face]) + (255,)


def cross(x, y):
    places = {(1, 0): "py", (0, 1): "nx", (1, 1): "pz", (2, 1): "px", (3, 1): "nz", (1, 2): "ny"}
    face = places.get((x // 16, y // 16))
    return face_texel(face, x % 16, y % 16, 16) if face else (0, 0, 0, 255)


def latitude_longitude(x, y):
    if y % 8 == 0 or x % 8 == 0:
        return (255, 255, 255, 255)
    return (4 * x, 8 * y, 255 - 4 * x, 255)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent
    for make in [alpha_modes, transparent_order, crossing_panes, vertex_colors, skin, morph, interpolations, moving_properties, cameras, quantization,
                 texture_transform, sparse, unlit, double_sided, primitive_modes, punctual_lights, second_texcoords,
                 mirrored_node, samplers, emission, metal_and_roughness, no_normals, two_scenes, extras, mirror_ball]:
        scene = Scene()
        make(scene)
        scene.write(folder / f"{make.__name__}.gltf")
    (folder / "cross.png").write_bytes(png(64, 48, cross))
    (folder / "latitude_longitude.png").write_bytes(png(64, 32, latitude_longitude))
    (folder / "six_faces").mkdir(exist_ok=True)
    for face in FACES:
        (folder / "six_faces" / f"{face}.png").write_bytes(png(16, 16, lambda x, y, f=face: face_texel(f, x, y, 16)))


if __name__ == "__main__":
    main()
