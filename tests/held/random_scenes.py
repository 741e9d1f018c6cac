"""Random scenes with all that Barrido draws of glTF 2.0, small ones: a dozen nodes, a few dozen vertices."""

import math
import random

import numpy as np

from glb import Glb

TRIANGLES, STRIP, FAN = 4, 5, 6


def numbers(rng: random.Random, count: int, low: float = -1.0, high: float = 1.0) -> list[float]:
    return [round(rng.uniform(low, high), 4) for _ in range(count)]


def quaternion(rng: random.Random) -> list[float]:
    q = np.array([rng.gauss(0, 1) for _ in range(4)])
    return (q / np.linalg.norm(q)).tolist()


def array(rng: random.Random, rows: int, columns: int, size: float = 1.0) -> np.ndarray:
    return np.array([[rng.uniform(-size, size) for _ in range(columns)] for _ in range(rows)])


def unit_rows(rows: np.ndarray) -> np.ndarray:
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


class RandomScene:
    """`glb` is the file; the rest is what a call may choose from."""

    def __init__(self, seed: int) -> None:
        self._rng = random.Random(seed)
        self.glb = Glb(self._rng)
        self._tree = self.glb.tree
        self.extensions: set[str] = set()
        self._add_nodes()
        self._add_images()
        for _ in range(self._rng.randint(1, 4)):
            self.glb.add("materials", self._material())
        self._add_skins()
        for _ in range(self._rng.randint(1, 3)):
            self._add_mesh()
        self._add_cameras()
        self._add_lights()
        for _ in range(self._rng.choice([0, 1, 1, 2])):
            self._add_animation()
        self._add_scenes()
        self._tree["extensionsUsed"] = sorted(self.extensions)
        if "KHR_mesh_quantization" in self.extensions:
            self._tree["extensionsRequired"] = ["KHR_mesh_quantization"]

    # Nodes

    def _add_nodes(self) -> None:
        count = self._rng.randint(4, 10)
        for i in range(count):
            self.glb.add("nodes", self._node(i))
        for i in range(1, count):
            if self._rng.random() < 0.6:
                self._tree["nodes"][self._rng.randrange(i)].setdefault("children", []).append(i)
        if self._rng.random() < 0.3:
            self._turn_order_round()

    def _turn_order_round(self) -> None:
        """Children may stand before their parents."""
        count = len(self._tree["nodes"])
        self._tree["nodes"].reverse()
        for node in self._tree["nodes"]:
            if "children" in node:
                node["children"] = [count - 1 - child for child in node["children"]]

    def _node(self, number: int) -> dict:
        rng, node = self._rng, {"name": f"node {number}"}
        if rng.random() < 0.2:
            linear = np.array(numbers(rng, 9)).reshape(3, 3) * 0.4 + np.diag([rng.choice([-1.0, 1.0]) for _ in range(3)])
            matrix = np.eye(4)
            matrix[:3, :3], matrix[:3, 3] = linear, numbers(rng, 3, -2, 2)
            node["matrix"] = matrix.T.flatten().tolist()
            return node
        if rng.random() < 0.8:
            node["translation"] = numbers(rng, 3, -2, 2)
        if rng.random() < 0.7:
            node["rotation"] = quaternion(rng)
        if rng.random() < 0.6:
            node["scale"] = [rng.choice([-1, 1, 1]) * rng.uniform(0.4, 1.6) for _ in range(3)]
        return node

    def _free_nodes(self, key: str) -> list[int]:
        return [i for i, node in enumerate(self._tree["nodes"]) if key not in node]

    # Materials

    def _add_images(self) -> None:
        if self._rng.random() < 0.3:
            return
        for _ in range(self._rng.randint(1, 3)):
            pixels = np.array([self._rng.randrange(256) for _ in range(2 * 4 * 4)], dtype=np.uint8).reshape(2, 4, 4)
            pixels[..., 3] = 255
            texture = {"source": self.glb.picture(pixels)}
            if self._rng.random() < 0.7:
                texture["sampler"] = self.glb.add("samplers", {
                    "minFilter": self._rng.choice([9728, 9729, 9984, 9985, 9986, 9987]), "magFilter": self._rng.choice([9728, 9729]),
                    "wrapS": self._rng.choice([10497, 33071, 33648]), "wrapT": self._rng.choice([10497, 33071, 33648])})
            self.glb.add("textures", texture)

    def _texture_info(self) -> dict:
        rng = self._rng
        info: dict = {"index": rng.randrange(len(self._tree["textures"])), "texCoord": rng.randrange(2)}
        if rng.random() < 0.6:
            self.extensions.add("KHR_texture_transform")
            transform: dict = {}
            if rng.random() < 0.8:
                transform["rotation"] = rng.uniform(-7, 7)
            if rng.random() < 0.8:
                transform["scale"] = numbers(rng, 2, -3, 3)
            if rng.random() < 0.7:
                transform["offset"] = numbers(rng, 2, -2, 2)
            if rng.random() < 0.3:
                transform["texCoord"] = rng.randrange(2)
            info["extensions"] = {"KHR_texture_transform": transform}
        return info

    def _material(self) -> dict:
        rng = self._rng
        pbr: dict = {"baseColorFactor": numbers(rng, 4, 0, 1), "metallicFactor": rng.choice([0, 0, 1, rng.random()]),
                     "roughnessFactor": rng.choice([0, 1, rng.random(), rng.random()])}
        material: dict = {"pbrMetallicRoughness": pbr, "doubleSided": rng.random() < 0.4}
        if "textures" in self._tree:
            for place, name, chance in ((pbr, "baseColorTexture", 0.6), (pbr, "metallicRoughnessTexture", 0.3),
                                        (material, "emissiveTexture", 0.3)):
                if rng.random() < chance:
                    place[name] = self._texture_info()
        if rng.random() < 0.5:
            material["emissiveFactor"] = numbers(rng, 3, 0, 1)
        material["alphaMode"] = rng.choice(["OPAQUE", "MASK", "BLEND", "BLEND"])
        if material["alphaMode"] == "MASK" and rng.random() < 0.7:
            material["alphaCutoff"] = round(rng.random(), 3)
        extensions: dict = {}
        if rng.random() < 0.15:
            extensions["KHR_materials_unlit"] = {}
        if rng.random() < 0.3:
            extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": round(rng.uniform(0, 4), 3)}
        if extensions:
            material["extensions"] = extensions
            self.extensions |= extensions.keys()
        if rng.random() < 0.3:
            material["extras"] = {"barrido": self._exact_material()}
        return material

    def _exact_material(self) -> dict:
        names = [name for name in ("ambient", "diffuse", "specular", "emission") if self._rng.random() < 0.5]
        exact: dict = {name: numbers(self._rng, 3, 0, 1) for name in names}
        if self._rng.random() < 0.5:
            exact["shininess"] = round(self._rng.uniform(0, 100), 3)
        return exact

    # Meshes

    def _add_skins(self) -> None:
        rng = self._rng
        for _ in range(rng.choice([0, 1, 2, 2])):
            joints = rng.sample(range(len(self._tree["nodes"])), rng.randint(2, min(6, len(self._tree["nodes"]))))
            skin: dict = {"joints": joints}
            if rng.random() < 0.8:
                bind = np.zeros((len(joints), 16))
                for row in bind:
                    matrix = np.eye(4)
                    matrix[:3, :3] += array(rng, 3, 3, 0.3)
                    matrix[:3, 3] = numbers(rng, 3)
                    row[:] = matrix.T.flatten()
                skin["inverseBindMatrices"] = self.glb.accessor(bind, vertex=False)
            self.glb.add("skins", skin)

    def _add_mesh(self) -> None:
        """A mesh, and the nodes that use it: with two skins it hangs on one each, so that its joints are both's."""
        rng = self._rng
        free = self._free_nodes("mesh")
        users = rng.sample(free, min(len(free), rng.choice([1, 1, 2])))
        skins = list(range(len(self._tree.get("skins", []))))
        skinned = bool(skins) and rng.random() < 0.6
        used = [rng.choice(skins) for _ in users] if skinned else []
        joints = min((len(self._tree["skins"][skin]["joints"]) for skin in used), default=0)
        targets = rng.choice([0, 0, 1, 2, 3])
        mesh: dict = {"primitives": [self._primitive(joints, targets) for _ in range(rng.choice([1, 1, 2]))]}
        if targets and rng.random() < 0.7:
            mesh["weights"] = numbers(rng, targets)
        index = self.glb.add("meshes", mesh)
        for i, node in enumerate(users):
            self._tree["nodes"][node]["mesh"] = index
            if skinned:
                self._tree["nodes"][node]["skin"] = used[i]
            if targets and rng.random() < 0.4:
                self._tree["nodes"][node]["weights"] = numbers(rng, targets)

    def _primitive(self, joints: int, targets: int) -> dict:
        rng, count = self._rng, self._rng.randint(4, 14)
        attributes = {"POSITION": self._positions(count)}
        if rng.random() < 0.7:
            attributes["NORMAL"] = self._normals(count)
        for i in range(2):
            attributes[f"TEXCOORD_{i}"] = self._texcoords(count)
        if rng.random() < 0.3:
            attributes["COLOR_0"] = self._colors(count)
        if joints:
            attributes |= self._skinning(count, joints)
        primitive: dict = {"attributes": attributes, "mode": rng.choice([TRIANGLES] * 6 + [STRIP, STRIP, FAN, 0, 1, 3])}
        if rng.random() < 0.6:
            primitive["indices"] = self._indices(count)
        if rng.random() < 0.9:
            primitive["material"] = rng.randrange(len(self._tree["materials"]))
        if targets:
            primitive["targets"] = [self._target(count, "NORMAL" in attributes) for _ in range(targets)]
        return primitive

    def _quantized(self, rows: np.ndarray, kinds: list, normalized: bool, sparse: bool = False) -> int:
        """Rows in [-1, 1] or [0, 1] as whole numbers."""
        dtype = self._rng.choice(kinds)
        stored = np.round(rows * (np.iinfo(dtype).max if normalized else min(100, np.iinfo(dtype).max)))
        return self.glb.accessor(stored, dtype, normalized, sparse=sparse)

    def _positions(self, count: int) -> int:
        rows = array(self._rng, count, 3)
        if self._rng.random() < 0.2:
            self.extensions.add("KHR_mesh_quantization")
            return self._quantized(rows, [np.int16], normalized=True)
        return self.glb.accessor(rows * 2)

    def _normals(self, count: int) -> int:
        rows = unit_rows(array(self._rng, count, 3))
        if self._rng.random() < 0.2:
            self.extensions.add("KHR_mesh_quantization")
            return self._quantized(rows, [np.int8, np.int16], normalized=True)
        return self.glb.accessor(rows)

    def _texcoords(self, count: int) -> int:
        rows = np.abs(array(self._rng, count, 2))
        if self._rng.random() < 0.3:
            return self._quantized(rows, [np.uint8, np.uint16], normalized=True, sparse=True)
        return self.glb.accessor(rows * 3 - 1, sparse=True)

    def _colors(self, count: int) -> int:
        rows = np.abs(array(self._rng, count, self._rng.choice([3, 4])))
        if self._rng.random() < 0.5:
            return self._quantized(rows, [np.uint8, np.uint16], normalized=True, sparse=True)
        return self.glb.accessor(rows, sparse=True)

    def _skinning(self, count: int, joints: int) -> dict:
        rng = self._rng
        which = np.array([[rng.randrange(joints) for _ in range(4)] for _ in range(count)])
        which[0, rng.randrange(4)] = joints - 1
        weights = np.abs(array(rng, count, 4)) + 0.05
        weights /= weights.sum(axis=1, keepdims=True)
        if rng.random() < 0.3:
            dtype = rng.choice([np.uint8, np.uint16])
            weights = self.glb.accessor(np.round(weights * np.iinfo(dtype).max), dtype, normalized=True)
        else:
            weights = self.glb.accessor(weights)
        return {"JOINTS_0": self.glb.accessor(which, rng.choice([np.uint8, np.uint16])), "WEIGHTS_0": weights}

    def _indices(self, count: int) -> int:
        rows = np.array([[self._rng.randrange(count)] for _ in range(3 * self._rng.randint(2, 6))])
        for i in range(2, len(rows)):  # Neighbours that differ, so that no triangle is a line.
            while rows[i] in rows[i - 2:i]:
                rows[i] = self._rng.randrange(count)
        return self.glb.accessor(rows, self._rng.choice([np.uint8, np.uint16, np.uint32]), vertex=False)

    def _target(self, count: int, normals: bool) -> dict:
        target = {}
        if self._rng.random() < 0.9:
            target["POSITION"] = self.glb.accessor(array(self._rng, count, 3), sparse=True)
        if normals and (self._rng.random() < 0.8 or not target):
            target["NORMAL"] = self.glb.accessor(array(self._rng, count, 3, 0.7), sparse=True)
        return target or {"POSITION": self.glb.accessor(array(self._rng, count, 3))}

    # Cameras, lights, animations

    def _add_cameras(self) -> None:
        rng = self._rng
        for node in rng.sample(self._free_nodes("camera"), rng.choice([0, 1, 2, 3])):
            if rng.random() < 0.5:
                near = rng.choice([0.0, rng.uniform(0.01, 1)])
                lens = {"type": "orthographic", "orthographic": {"xmag": rng.uniform(0.5, 5), "ymag": rng.uniform(0.5, 5),
                                                                 "znear": near, "zfar": near + rng.uniform(1, 30)}}
            else:
                lens = {"type": "perspective", "perspective": {"yfov": rng.uniform(0.2, 2), "znear": rng.uniform(0.01, 1)}}
                if rng.random() < 0.6:
                    lens["perspective"]["zfar"] = lens["perspective"]["znear"] + rng.uniform(1, 30)
                if rng.random() < 0.5:
                    lens["perspective"]["aspectRatio"] = rng.uniform(0.5, 2)
            self._tree["nodes"][node]["camera"] = self.glb.add("cameras", lens)

    def _add_lights(self) -> None:
        rng = self._rng
        nodes = rng.sample(range(len(self._tree["nodes"])), rng.choice([0, 1, 2, 4]))
        if not nodes:
            return
        self.extensions.add("KHR_lights_punctual")
        lights = [self._light() for _ in range(rng.randint(1, 3))]
        self._tree["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
        for node in nodes:
            self._tree["nodes"][node]["extensions"] = {"KHR_lights_punctual": {"light": rng.randrange(len(lights))}}

    def _light(self) -> dict:
        rng = self._rng
        light: dict = {"type": rng.choice(["directional", "point", "point", "spot", "spot"]), "intensity": 10**rng.uniform(-1.5, 3)}
        if rng.random() < 0.6:
            light["color"] = numbers(rng, 3, 0, 1)
        placed = light["type"] != "directional"
        if placed and rng.random() < 0.6:
            light["range"] = rng.uniform(1, 8)
        exact: dict = {"intensity": round(rng.uniform(-1, 2), 3)} if rng.random() < 0.25 else {}
        if placed and exact and rng.random() < 0.5:
            exact["attenuation"] = numbers(rng, 3, 0.1, 1)
        if light["type"] == "spot":
            outer = rng.uniform(0.2, 1.5)
            light["spot"] = {"outerConeAngle": outer, "innerConeAngle": rng.uniform(0, 0.9) * outer}
            if exact and rng.random() < 0.5:
                exact["spotExponent"] = round(rng.uniform(0, 20), 2)
        if exact:
            light["extras"] = {"barrido": exact}
        return light

    def _add_animation(self) -> None:
        rng = self._rng
        animation: dict = {"samplers": [], "channels": []}
        paths = [(i, path) for i, node in enumerate(self._tree["nodes"]) for path in ("translation", "rotation", "scale", "weights")
                 if (self._targets_of(node) if path == "weights" else "matrix" not in node)]
        for node, path in rng.sample(paths, min(len(paths), rng.randint(1, 6))):
            animation["channels"].append({"sampler": len(animation["samplers"]), "target": {"node": node, "path": path}})
            animation["samplers"].append(self._sampler(path, self._targets_of(self._tree["nodes"][node])))
        pointers = self._pointers()
        for pointer, width, low, high in rng.sample(pointers, min(len(pointers), rng.choice([0, 0, 1, 3]))):
            animation["channels"].append({"sampler": len(animation["samplers"]), "target": {
                "path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": pointer}}}})
            animation["samplers"].append(self._sampler_of(width, low, high))
            self.extensions.add("KHR_animation_pointer")
        if animation["channels"]:
            self.glb.add("animations", animation)

    def _pointers(self) -> list[tuple[str, int, float, float]]:
        """With the number of components, and between which values they move."""
        pointers: list[tuple[str, int, float, float]] = []
        for i, material in enumerate(self._tree["materials"]):
            pbr = f"/materials/{i}/pbrMetallicRoughness/"
            if "baseColorTexture" in material.get("pbrMetallicRoughness", {}):
                place = pbr + "baseColorTexture/extensions/KHR_texture_transform/"
                pointers += [(place + "offset", 2, -1, 1), (place + "scale", 2, 0.5, 2), (place + "rotation", 1, -3, 3)]
            pointers += [(pbr + "baseColorFactor", 4, 0.1, 1), (pbr + "metallicFactor", 1, 0, 1), (pbr + "roughnessFactor", 1, 0.2, 1),
                         (f"/materials/{i}/emissiveFactor", 3, 0, 1)]
        for i, light in enumerate(self._tree.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])):
            place = f"/extensions/KHR_lights_punctual/lights/{i}/"
            pointers += [(place + "intensity", 1, 0.5, 20), (place + "color", 3, 0.1, 1)]
            if light["type"] == "spot":
                pointers.append((place + "spot/outerConeAngle", 1, 0.2, 1.5))
        for i, camera in enumerate(self._tree.get("cameras", [])):
            pointers.append((f"/cameras/{i}/perspective/yfov", 1, 0.2, 2) if camera["type"] == "perspective"
                            else (f"/cameras/{i}/orthographic/ymag", 1, 0.5, 5))
        pointers += [(f"/nodes/{i}/translation", 3, -1, 1) for i, node in enumerate(self._tree["nodes"]) if "matrix" not in node]
        return pointers

    def _sampler_of(self, width: int, low: float, high: float) -> dict:
        """Of numbers between these; splines may leave them."""
        rng, keys = self._rng, self._rng.randint(2, 4)
        interpolation = rng.choice(["STEP", "LINEAR", "CUBICSPLINE"])
        times = np.cumsum([rng.uniform(0, 0.8)] + [rng.uniform(0.05, 1) for _ in range(keys - 1)])
        input_ = self.glb.accessor(times[:, None], vertex=False)
        self._tree["accessors"][input_] |= {"min": [float(np.float32(times[0]))], "max": [float(np.float32(times[-1]))]}
        rows = (array(rng, keys * (3 if interpolation == "CUBICSPLINE" else 1), width) + 1) / 2 * (high - low) + low
        return {"input": input_, "output": self.glb.accessor(rows, vertex=False), "interpolation": interpolation}

    def _targets_of(self, node: dict) -> int:
        return len(self._tree["meshes"][node["mesh"]]["primitives"][0].get("targets", [])) if "mesh" in node else 0

    def _sampler(self, path: str, targets: int) -> dict:
        rng, keys = self._rng, self._rng.randint(1, 5)
        interpolation = rng.choice(["STEP", "LINEAR", "LINEAR", "CUBICSPLINE"])
        if interpolation == "CUBICSPLINE":
            keys = max(keys, 2)
        times = np.cumsum([rng.uniform(0, 0.8)] + [rng.uniform(0.05, 1) for _ in range(keys - 1)])
        input_ = self.glb.accessor(times[:, None], vertex=False)
        self._tree["accessors"][input_] |= {"min": [float(np.float32(times[0]))], "max": [float(np.float32(times[-1]))]}
        elements = keys * (3 if interpolation == "CUBICSPLINE" else 1)
        width = {"rotation": 4, "weights": 1}.get(path, 3)
        rows = array(rng, elements * (targets if path == "weights" else 1), width)
        if path == "rotation" and interpolation != "CUBICSPLINE":
            rows = unit_rows(rows)
        if path == "rotation" and interpolation == "CUBICSPLINE":
            rows = self._spline_of_rotations(keys)
        if path == "scale":
            rows = rows * 0.5 + 1
        dtype = rng.choice([np.int8, np.int16]) if path in ("rotation", "weights") and rng.random() < 0.4 else None
        if dtype is None:
            output = self.glb.accessor(rows, vertex=False)
        else:
            output = self.glb.accessor(np.round(rows * np.iinfo(dtype).max), dtype, normalized=True, vertex=False)
        sampler = {"input": input_, "output": output, "interpolation": interpolation}
        if interpolation == "LINEAR" and rng.random() < 0.5:
            del sampler["interpolation"]
        return sampler

    def _spline_of_rotations(self, keys: int) -> np.ndarray:
        """Points that stay near each other, so that what is between them has a length."""
        points = unit_rows(array(self._rng, 1, 4) + array(self._rng, keys, 4, 0.3))
        rows = array(self._rng, 3 * keys, 4, 0.4)
        rows[1::3] = points
        return rows

    def _add_scenes(self) -> None:
        rng = self._rng
        children = {child for node in self._tree["nodes"] for child in node.get("children", [])}
        roots = [i for i in range(len(self._tree["nodes"])) if i not in children]
        for _ in range(rng.choice([1, 1, 2])):
            nodes = rng.sample(roots, len(roots) if rng.random() < 0.7 else rng.randint(1, len(roots)))
            scene: dict = {"nodes": nodes}
            if rng.random() < 0.3:
                scene["extras"] = {"barrido": self._exact_scene()}
            self.glb.add("scenes", scene)
        if rng.random() < 0.7:
            self._tree["scene"] = rng.randrange(len(self._tree["scenes"]))

    def _exact_scene(self) -> dict:
        rng = self._rng
        exact: dict = {}
        if rng.random() < 0.5:
            exact["ambient"] = numbers(rng, 3, 0, 1)
        if rng.random() < 0.5:
            exact["background"] = numbers(rng, rng.choice([3, 4]), 0, 1)
        if rng.random() < 0.4:
            exact["fog"] = {"mode": "exp", "density": round(rng.uniform(0, math.pi), 3), "color": numbers(rng, 3, 0, 1)}
        return exact
