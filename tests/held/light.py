"""Lights: KHR_lights_punctual, what Barrido makes of it for fixed function, and how it exposes it (docs/scene.md)."""

import dataclasses
import math

import numpy as np

from pose import Pose, Vertices, unit

THREE_LIGHTS = [((-0.55, 0.60, 0.58), 0.82), ((0.80, 0.10, 0.59), 0.41), ((0.15, 0.62, -0.77), 0.45)]
MOST_LIGHTS = 64


@dataclasses.dataclass
class Light:
    """In the world. Of directional lights `position` is the direction towards them."""

    color: np.ndarray  # Times intensity
    position: np.ndarray
    directional: bool = False
    direction: np.ndarray | None = None  # Spots
    attenuation: tuple[float, float, float] = (1.0, 0.0, 0.0)
    range: float = 0.0
    cone: tuple[float, float] | None = None  # Inner and outer half angles of a soft cone
    cutoff: float | None = None  # Half angle of a hard one, with `exponent`
    exponent: float = 0.0
    physical: bool = False


def file_light(source: dict, world: np.ndarray) -> Light:
    """It shines along its node's −Z."""
    exact = source.get("extras", {}).get("barrido", {})
    intensity = exact.get("intensity", source.get("intensity", 1.0) / math.pi)
    color = np.array(source.get("color", [1, 1, 1]), dtype=np.float64) * intensity
    direction = unit(-world[:3, 2])
    physical = "intensity" not in exact
    if source["type"] == "directional":
        return Light(color, -direction, directional=True, physical=physical)
    light = Light(color, world[:3, 3], range=source.get("range", 0.0), physical=physical)
    light.attenuation = tuple(exact.get("attenuation", (0, 0, 1) if physical else (1, 0, 0)))
    if source["type"] == "spot":
        spot = source["spot"]
        light.direction = direction
        outer = spot.get("outerConeAngle", math.pi / 4)
        if "spotExponent" in exact:
            light.cutoff, light.exponent = outer, exact["spotExponent"]
        else:
            light.cone = (spot.get("innerConeAngle", 0.0), outer)
    return light


def weakened(light: Light, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """How much of the light comes to each point, whichever way it faces, and unit vectors towards the light."""
    if light.directional:
        return np.ones(len(points)), np.broadcast_to(light.position, points.shape)
    offsets = light.position - points
    distance = np.linalg.norm(offsets, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        towards = offsets / distance[:, None]
        constant, linear, quadratic = light.attenuation
        factor = 1 / (constant + linear * distance + quadratic * distance**2)
    if light.range > 0:
        factor = factor * np.clip(1 - (distance / light.range)**4, 0, 1)
    if light.cone is not None:
        inner, outer = math.cos(light.cone[0]), math.cos(light.cone[1])
        factor = factor * np.clip((-(towards @ light.direction) - outer) / max(0.001, inner - outer), 0, 1)**2
    return np.where(distance > 0, factor, 0.0), np.where(distance[:, None] > 0, towards, 0.0)


def metered(lights: list[Light], parts: list[Vertices], drawn: list[np.ndarray]) -> float:
    """The factor for physical lights: what the 85th of a hundred lit vertices sends back is brought into [0.25, 1]."""
    lights = [light for light in lights if light.physical]
    count = sum(len(part.positions) for part in parts)
    if not lights or count == 0:
        return 1.0
    step = count // 4096 + 1
    points, normals = [], []
    for part in parts:
        matrix = part.world_from_object
        points.append(part.positions @ matrix[:3, :3].T + matrix[:3, 3])
        if part.normals is None:
            normals.append(np.zeros_like(part.positions))
        else:
            moved = part.normals @ np.linalg.inv(matrix[:3, :3])
            normals.append(moved / np.linalg.norm(moved, axis=1, keepdims=True))
    chosen = np.concatenate(drawn)[::step]
    positions, facing = np.concatenate(points)[::step][chosen], np.concatenate(normals)[::step][chosen]
    received = np.zeros(len(positions))
    for light in lights:
        factor, towards = weakened(light, positions)
        cosine = np.where(np.any(facing != 0, axis=1), np.maximum((facing * towards).sum(axis=1), 0), 1.0)
        received += factor * cosine * light.color.max()
    lit = np.sort(received[received > 0])
    if len(lit) == 0:
        return 1.0
    middle = lit[(len(lit) - 1) * 85 // 100]
    return min(max(middle, 0.25), 1.0) / middle


@dataclasses.dataclass
class LightChoice:
    """What a call asks of the lights. `user`: lights and whether they move with the eye."""

    user: list[tuple[Light, bool]] = dataclasses.field(default_factory=list)
    none: bool = False
    off: list[int] = dataclasses.field(default_factory=list)
    ambient: list[float] | None = None


def moved(light: Light, world_from_eye: np.ndarray) -> Light:
    turn = world_from_eye[:3, :3]
    position = turn @ light.position + (0 if light.directional else world_from_eye[:3, 3])
    return dataclasses.replace(light, position=position, direction=None if light.direction is None else turn @ light.direction)


def three_lights() -> list[Light]:
    return [Light(np.full(3, intensity), unit(np.array(towards)), directional=True) for towards, intensity in THREE_LIGHTS]


def chosen_lights(tree: dict, nodes: list[int], pose: Pose, choice: LightChoice, world_from_eye: np.ndarray,
                  meter: float) -> list[Light]:
    """The user's, else the file's, else three that are fixed to the eye."""
    if choice.none:
        return []
    lights = [moved(light, world_from_eye) if with_eye else light for light, with_eye in choice.user]
    if not lights:
        for light in file_lights(tree, nodes, pose):
            lights.append(dataclasses.replace(light, color=light.color * meter) if light.physical else light)
    if not lights:
        lights = [moved(light, world_from_eye) for light in three_lights()]
    return [light for i, light in enumerate(lights[:MOST_LIGHTS]) if i not in choice.off]


def file_lights(tree: dict, nodes: list[int], pose: Pose) -> list[Light]:
    sources = tree.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    found = []
    for node in nodes:
        extension = tree["nodes"][node].get("extensions", {}).get("KHR_lights_punctual")
        if extension:
            found.append(file_light(sources[extension["light"]], pose.world[node]))
    return found


def ambient_of(scene: dict, choice: LightChoice) -> list[float]:
    if choice.ambient is not None:
        return choice.ambient
    own = scene.get("extras", {}).get("barrido", {})
    return own.get("ambient", [1.0] * 3 if choice.none else [0.05] * 3)
