"""Where the vertices of a glTF scene are at a moment: node matrices, animations, morph targets and skins, written from the
glTF 2.0 specification in double precision. Matrices multiply columns from the left; arrays have a row an element."""

import dataclasses
import re

import numpy as np

from glb import Glb

NODE = re.compile(r"/nodes/(\d+)/(translation|rotation|scale|weights)$")


def pointer_of(channel: dict) -> str | None:
    return channel["target"].get("extensions", {}).get("KHR_animation_pointer", {}).get("pointer")


def core_target(channel: dict) -> dict | None:
    """The target as glTF's core would write it; None for what is no node's."""
    pointer = pointer_of(channel)
    if pointer is None:
        return channel["target"]
    node = NODE.match(pointer)
    return {"node": int(node[1]), "path": node[2]} if node else None


def matrix_of(numbers: list[float]) -> np.ndarray:
    """A matrix that stands column by column."""
    side = round(len(numbers) ** 0.5)
    return np.array(numbers, dtype=np.float64).reshape(side, side).T


def unit(vector: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else vector


def rotation_of(quaternion: np.ndarray) -> np.ndarray:
    """x, y, z, w of a unit quaternion (q, w): it takes v to v + 2w(q × v) + 2 q × (q × v)."""
    x, y, z, w = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def local_matrix(node: dict) -> np.ndarray:
    if "matrix" in node:
        return matrix_of(node["matrix"])
    matrix = np.eye(4)
    scale = np.array(node.get("scale", [1, 1, 1]), dtype=np.float64)
    matrix[:3, :3] = rotation_of(unit(np.array(node.get("rotation", [0, 0, 0, 1]), dtype=np.float64))) @ np.diag(scale)
    matrix[:3, 3] = node.get("translation", [0, 0, 0])
    return matrix


def slerp(a: np.ndarray, b: np.ndarray, t: float) -> np.ndarray:
    """The shorter way (appendix C.4)."""
    cosine = float(a @ b)
    if cosine < 0:
        b, cosine = -b, -cosine
    angle = np.arccos(min(cosine, 1.0))
    if angle < 1e-6:
        return unit(a * (1 - t) + b * t)
    return (np.sin((1 - t) * angle) * a + np.sin(t * angle) * b) / np.sin(angle)


def hermite(before: np.ndarray, after: np.ndarray, t: float, duration: float) -> np.ndarray:
    """Keys are (in-tangent, value, out-tangent) (appendix C.5)."""
    basis = [2 * t**3 - 3 * t**2 + 1, duration * (t**3 - 2 * t**2 + t), -2 * t**3 + 3 * t**2, duration * (t**3 - t**2)]
    return basis[0] * before[1] + basis[1] * before[2] + basis[2] * after[1] + basis[3] * after[0]


def sampled(times: np.ndarray, keys: np.ndarray, interpolation: str, time: float, is_rotation: bool) -> np.ndarray:
    """`keys`: an element a key, or three with CUBICSPLINE. Before the first and after the last key nothing moves."""
    cubic = interpolation == "CUBICSPLINE"
    point = (lambda key: keys[key][1]) if cubic else (lambda key: keys[key])
    last = len(times) - 1
    if time <= times[0] or time >= times[last]:
        value = point(0 if time <= times[0] else last)
        return unit(value) if is_rotation else value
    key = int(np.nonzero(times <= time)[0][-1])
    duration = times[key + 1] - times[key]
    t = (time - times[key]) / duration
    if interpolation == "STEP":
        value = point(key)
    elif cubic:
        value = hermite(keys[key], keys[key + 1], t, duration)
    elif is_rotation:
        value = slerp(unit(keys[key]), unit(keys[key + 1]), t)
    else:
        value = keys[key] * (1 - t) + keys[key + 1] * t
    return unit(value) if is_rotation else value


@dataclasses.dataclass
class Vertices:
    """What a primitive of a node is at a moment. `quality`: how much of a normal is left after cancellation, (0, 1]."""

    world_from_object: np.ndarray
    positions: np.ndarray  # Object space
    normals: np.ndarray | None  # Object space, unit length
    quality: np.ndarray
    skinned: bool = False
    mirrored: np.ndarray | None = None  # Vertices whose joints turn left into right


class Pose:
    """A scene at `time` of an animation; None: as it stands."""

    def __init__(self, glb: Glb, animation: int | None = None, time: float = 0.0) -> None:
        self._glb = glb
        self._tree = glb.tree
        self._nodes = [dict(node) for node in glb.tree["nodes"]]
        self.weights = [self._standing_weights(node) for node in self._nodes]
        if animation is not None:
            for channel in self._tree["animations"][animation]["channels"]:
                if (target := core_target(channel)) is not None:
                    self._apply(self._tree["animations"][animation], channel, target, time)
        self.world: list[np.ndarray] = [np.eye(4)] * len(self._nodes)
        children = {child for node in self._nodes for child in node.get("children", [])}
        for root in set(range(len(self._nodes))) - children:
            self._place(root, np.eye(4))

    def _target_count(self, node: dict) -> int:
        return len(self._tree["meshes"][node["mesh"]]["primitives"][0].get("targets", [])) if "mesh" in node else 0

    def _standing_weights(self, node: dict) -> np.ndarray:
        count = self._target_count(node)
        mesh = self._tree["meshes"][node["mesh"]] if "mesh" in node else {}
        return np.array(node.get("weights", mesh.get("weights", [0.0] * count)), dtype=np.float64)

    def _apply(self, animation: dict, channel: dict, target: dict, time: float) -> None:
        sampler = animation["samplers"][channel["sampler"]]
        node, path = target["node"], target["path"]
        times = self._glb.values[sampler["input"]][:, 0]
        interpolation = sampler.get("interpolation", "LINEAR")
        width = {"rotation": 4, "weights": self._target_count(self._nodes[node])}.get(path, 3)
        shape = (len(times), 3, width) if interpolation == "CUBICSPLINE" else (len(times), width)
        keys = self._glb.values[sampler["output"]].reshape(shape)
        value = sampled(times, keys, interpolation, time, path == "rotation")
        if path == "weights":
            self.weights[node] = value
        else:
            self._nodes[node][path] = value

    def _place(self, node: int, parent: np.ndarray) -> None:
        self.world[node] = parent @ local_matrix(self._nodes[node])
        for child in self._nodes[node].get("children", []):
            self._place(child, self.world[node])

    def vertices(self, node: int, primitive: dict) -> Vertices:
        """Morph targets first, then the skin, whose vertices are in the world whatever the node's own matrix."""
        values = self._glb.values
        positions = values[primitive["attributes"]["POSITION"]].copy()
        normals, quality = None, np.ones(len(positions))
        if "NORMAL" in primitive["attributes"]:
            normals = values[primitive["attributes"]["NORMAL"]].copy()
            normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        total = np.ones(len(positions))
        for target, weight in zip(primitive.get("targets", []), self.weights[node], strict=False):
            if "POSITION" in target:
                positions += weight * values[target["POSITION"]]
            if "NORMAL" in target and normals is not None:
                normals += weight * values[target["NORMAL"]]
                total += abs(weight) * np.linalg.norm(values[target["NORMAL"]], axis=1)
        if normals is not None:
            quality = np.minimum(1.0, np.linalg.norm(normals, axis=1) / total)
        world = self.world[node]
        skinned = "skin" in self._nodes[node] and "JOINTS_0" in primitive["attributes"]
        if skinned:
            joints = self._joint_matrices(self._nodes[node]["skin"])
            matrices = weighted(joints, self._glb.values, primitive["attributes"])
            positions = np.einsum("vij,vj->vi", matrices[:, :3, :3], positions) + matrices[:, :3, 3]
            world = np.eye(4)
            if normals is not None:
                normals, kept = carried(matrices[:, :3, :3], normals)
                quality = quality * kept
        if normals is not None:
            normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        # A sum of joints that mirror nothing may fold a surface, but means no mirror.
        means_mirror = skinned and bool((np.linalg.det(joints[:, :3, :3]) < 0).any())
        mirrored = np.linalg.det(matrices[:, :3, :3]) < 0 if means_mirror else None
        return Vertices(world, positions, normals, quality, skinned, mirrored)

    def _joint_matrices(self, skin_index: int) -> np.ndarray:
        skin = self._tree["skins"][skin_index]
        joints = np.array([self.world[joint] for joint in skin["joints"]])
        if "inverseBindMatrices" in skin:
            bind = self._glb.values[skin["inverseBindMatrices"]][:len(joints)].reshape(-1, 4, 4).transpose(0, 2, 1)
            joints = joints @ bind
        return joints


def weighted(joints: np.ndarray, values: list[np.ndarray], attributes: dict) -> np.ndarray:
    """A matrix a vertex (section 3.7.3.3). Weights are used as if their sum were 1."""
    weights = values[attributes["WEIGHTS_0"]]
    weights = weights / weights.sum(axis=1, keepdims=True)
    return np.einsum("vk,vkij->vij", weights, joints[values[attributes["JOINTS_0"]].astype(int)])


def carried(matrices: np.ndarray, normals: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Normals by the inverse transposed of matrices (count, 3, 3), not normalized; and how well that can be told."""
    determinants = np.linalg.det(matrices)
    sizes = np.linalg.norm(matrices, axis=(1, 2))
    safe = np.where(np.abs(determinants) > 1e-9 * sizes**3, determinants, 1.0)
    inverse = np.linalg.inv(np.where(np.abs(determinants)[:, None, None] > 1e-9 * sizes[:, None, None]**3, matrices, np.eye(3)))
    moved = np.einsum("vji,vj->vi", inverse, normals)
    # The inverse times the determinant is made of products of two entries: that size is what is lost in rounding.
    quality = np.linalg.norm(moved, axis=1) * np.abs(safe) / sizes**2
    return moved, np.where(np.abs(determinants) > 1e-9 * sizes**3, np.minimum(quality, np.abs(determinants) / sizes**3), 0.0)
