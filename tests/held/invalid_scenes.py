"""Scenes that must be refused because two of their parts do not go together, and a word of the message."""

import random

import numpy as np

from glb import Glb


def skinned(rng: random.Random, joints: list[int], used: list[int], largest: list[int]) -> bytes:
    """A scene with a skin for each of `joints`, so many joints; mesh i names joints up to `largest[i]` and hangs on skin
    `used[i]`."""
    glb = Glb(rng)
    bones = [glb.add("nodes", {}) for _ in range(max(joints))]
    for count in joints:
        glb.add("skins", {"joints": bones[:count]})
    for skin, joint in zip(used, largest, strict=True):
        which = np.zeros((3, 4))
        which[rng.randrange(3), rng.randrange(4)] = joint
        attributes = {"POSITION": glb.accessor(np.eye(3)), "JOINTS_0": glb.accessor(which, np.uint8),
                      "WEIGHTS_0": glb.accessor(np.full((3, 4), 0.25))}
        mesh = glb.add("meshes", {"primitives": [{"attributes": attributes}]})
        glb.add("nodes", {"mesh": mesh, "skin": skin})
    glb.add("scenes", {"nodes": list(range(len(glb.tree["nodes"])))})
    return glb.bytes()


def shared(rng: random.Random, joints: list[int], largest: int) -> bytes:
    """One mesh on a skin each of `joints` joints."""
    glb = Glb(rng)
    bones = [glb.add("nodes", {}) for _ in range(max(joints))]
    which = np.zeros((3, 4))
    which[rng.randrange(3), rng.randrange(4)] = largest
    attributes = {"POSITION": glb.accessor(np.eye(3)), "JOINTS_0": glb.accessor(which, np.uint8),
                  "WEIGHTS_0": glb.accessor(np.full((3, 4), 0.25))}
    mesh = glb.add("meshes", {"primitives": [{"attributes": attributes}]})
    for count in joints:
        glb.add("nodes", {"mesh": mesh, "skin": glb.add("skins", {"joints": bones[:count]})})
    glb.add("scenes", {"nodes": list(range(len(glb.tree["nodes"])))})
    return glb.bytes()


def invalid_scenes(seed: int) -> list[tuple[bytes, str]]:
    rng = random.Random(seed)
    cases = []
    for joints, used, largest in (([2, 5], [0, 1], [3, 3]), ([5, 2], [0, 1], [3, 3]), ([5, 2], [1, 0], [2, 4]),
                                  ([1, 4, 2], [2, 1, 0], [1, 3, 1]), ([3, 3], [0, 1], [2, 3])):
        cases.append((skinned(rng, joints, used, largest), "names joint"))
    for joints, largest in (([2, 5], 3), ([5, 2], 3), ([4, 4, 3], 3)):
        cases.append((shared(rng, joints, largest), "names joint"))
    return cases
