"""Animations of anything that a JSON pointer leads to (KHR_animation_pointer): the file's tree as it is at a moment."""

import copy

import numpy as np

from glb import Glb
from pose import core_target, pointer_of, sampled

# What a property may be, by the end of its pointer.
BOUNDS = {"baseColorFactor": (0, 1), "metallicFactor": (0, 1), "roughnessFactor": (0, 1), "emissiveFactor": (0, np.inf),
          "intensity": (0, np.inf), "color": (0, np.inf), "outerConeAngle": (0, np.pi / 2), "yfov": (1e-4, 3.1), "ymag": (1e-6, np.inf)}


def put(tree: dict, pointer: str, value: object) -> None:
    *way, last = pointer.split("/")[1:]
    place = tree
    for name in way:
        place = place[int(name)] if isinstance(place, list) else place.setdefault(name, {})
    place[last] = value


def at_moment(glb: Glb, animation: int | None, time: float) -> Glb:
    """The file itself where nothing but nodes moves."""
    if animation is None:
        return glb
    animated = glb.tree["animations"][animation]
    moving = [channel for channel in animated["channels"] if core_target(channel) is None]
    if not moving:
        return glb
    moved = copy.copy(glb)
    moved.tree = copy.deepcopy(glb.tree)
    for channel in moving:
        sampler, pointer = animated["samplers"][channel["sampler"]], pointer_of(channel)
        times = glb.values[sampler["input"]][:, 0]
        interpolation = sampler.get("interpolation", "LINEAR")
        values = glb.values[sampler["output"]]
        keys = values.reshape(len(times), 3, -1) if interpolation == "CUBICSPLINE" else values
        value = np.clip(sampled(times, keys, interpolation, time, False), *BOUNDS.get(pointer.rsplit("/", 1)[1], (-np.inf, np.inf)))
        put(moved.tree, pointer, value.tolist() if len(value) > 1 else float(value[0]))
    for light in moved.tree.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", []):
        if "spot" in light:
            light["spot"]["innerConeAngle"] = min(light["spot"].get("innerConeAngle", 0.0), light["spot"]["outerConeAngle"])
    return moved
