"""A perfect mirror shows what stands before it as it would be seen itself, whatever is done to the finished picture."""

import json
import random

import numpy as np

from glb import Glb


def quad(glb: Glb, half: float, normal: list[float], material: int) -> dict:
    """A square about the origin that faces `normal`, which is ±z."""
    corners = np.array([[-half, -half, 0], [half, -half, 0], [half, half, 0], [-half, half, 0]])
    indices = np.array([[0], [1], [2], [0], [2], [3]] if normal[2] > 0 else [[0], [2], [1], [0], [3], [2]])
    return {"primitives": [{"attributes": {"POSITION": glb.accessor(corners), "NORMAL": glb.accessor(np.tile(normal, (4, 1)))},
                            "indices": glb.accessor(indices, np.uint16, vertex=False), "material": material}]}


def scene(color: list[float]) -> bytes:
    """A mirror at z = 0 that faces +Z; a coloured wall at z = 10 that faces it, behind the eye at z = 4. Camera 0 sees the
    mirror, camera 1 the wall."""
    glb = Glb(random.Random(1))
    glb.add("materials", {"pbrMetallicRoughness": {"roughnessFactor": 0}})
    glb.add("materials", {"pbrMetallicRoughness": {"baseColorFactor": [*color, 1]}, "extensions": {"KHR_materials_unlit": {}}})
    glb.add("cameras", {"type": "perspective", "perspective": {"yfov": 0.3, "znear": 0.1}})
    glb.add("meshes", quad(glb, 2, [0, 0, 1], 0))
    glb.add("meshes", quad(glb, 30, [0, 0, -1], 1))
    glb.add("nodes", {"mesh": 0})
    glb.add("nodes", {"mesh": 1, "translation": [0, 0, 10]})
    glb.add("nodes", {"camera": 0, "translation": [0, 0, 4]})
    glb.add("nodes", {"camera": 0, "translation": [0, 0, 4], "rotation": [0, 1, 0, 0]})
    glb.add("scenes", {"nodes": [0, 1, 2, 3]})
    glb.tree["extensionsUsed"] = ["KHR_materials_unlit"]
    return glb.bytes()


def middle(program, camera: int, words: list[str]) -> tuple[int, int, int]:
    """The pixel in the middle, as `inspect` tells it."""
    _, text, error = program("inspect", "mirror.glb", "--pixel", "16,16", "--json", "--resolution", "32,32", "--no-lights",
                             "--environment", "dynamic", "--camera-index", str(camera), *words)
    if not text:
        raise RuntimeError(error.decode())
    return tuple(json.loads(text)["rgba8"][:3])


def check(program, lines: list[str]) -> int:
    (program.folder / "mirror.glb").write_bytes(scene([0.6, 0.3, 0.1]))
    choices = [[], ["--tone-map", "reinhard"], ["--exposure", "1"], ["--exposure", "-1.5", "--tone-map", "reinhard"],
               ["--color-management", "none"], ["--color-management", "none", "--tone-map", "reinhard"]]
    for words in choices:
        mirrored, seen = middle(program, 0, words), middle(program, 1, words)
        # The map that the mirror shows holds bytes.
        if max(abs(a - b) for a, b in zip(mirrored, seen, strict=True)) > 2:
            lines.append(f"{' '.join(words)}: the mirror shows {mirrored} for {seen}")
    return len(choices)
