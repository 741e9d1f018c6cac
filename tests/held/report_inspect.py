"""`inspect --json` at pixels of random scenes: corners, position, lights and sums against the second implementation, and the
colour against the picture."""

import json
import math
import random

import numpy as np

from compare_frame import clear_color
from frames import FAN, STRIP, TRIANGLES, Call, Draw, Frame, Frames
from light import Light, weakened
from random_scenes import RandomScene

BOUND = 2e-4


class Report:
    """What differs; `place` is said before it."""

    def __init__(self, lines: list[str], place: str) -> None:
        self._lines, self._place, self.count = lines, place, 0

    def near(self, what: str, theirs, ours, bound: float = BOUND) -> None:
        theirs, ours = np.asarray(theirs, dtype=np.float64), np.asarray(ours, dtype=np.float64)
        self.count += ours.size
        if theirs.shape != ours.shape or np.any(np.abs(theirs - ours) > bound * np.maximum(1, np.abs(ours))):
            self._lines.append(f"{self._place}: {what} is {theirs.tolist()}, not {ours.tolist()}")


def make_call(rng: random.Random, path: str, tree: dict) -> Call:
    """One frame, framed, with the file's lights."""
    call = Call(words=[path, "--camera-index", "none"], path=path)
    call.view.ignore_cameras = True
    call.view.width, call.view.height = 48, 32
    call.words += ["--resolution", "48,32"]
    call.view.azimuth = round(rng.uniform(-180, 180), 2)
    call.words += ["--azimuth", repr(call.view.azimuth)]
    if tree.get("animations"):
        call.time = round(rng.uniform(0, 3), 2)
        call.words += ["--time", repr(call.time)]
    return call


def triangle_in_view(rng: random.Random, frame: Frame) -> tuple[int, int] | None:
    """The pixel in the middle of some triangle."""
    draws = [draw for draw in frame.draws if draw.source.get("mode", TRIANGLES) in (TRIANGLES, STRIP, FAN) and draw.corners]
    if not draws:
        return None
    draw = rng.choice(draws)
    triangle = rng.randrange(len(draw.corners) // 3)
    middle = eye_corners(frame, draw)[3 * triangle:3 * triangle + 3].mean(axis=0)
    clip = frame.clip_from_eye @ np.append(middle, 1)
    x, y = (clip[:2] / clip[3] + 1) / 2 * [48, 32]
    return min(max(int(x), 0), 47), min(max(31 - int(y), 0), 31)


def eye_corners(frame: Frame, draw: Draw) -> np.ndarray:
    matrix = frame.eye_from_world @ draw.vertices.world_from_object
    return draw.vertices.positions[draw.corners] @ matrix[:3, :3].T + matrix[:3, 3]


def check_fragment(frame: Frame, fragment: dict, report: Report) -> None:
    source = fragment["source"]
    draw = next(draw for draw in frame.draws if (draw.node, draw.primitive) == (source["node"]["index"], source["primitive"]))
    report.near("mesh", source["mesh"]["index"], draw.mesh, 0)
    report.near("material", -1 if source["material"]["index"] is None else source["material"]["index"],
                -1 if draw.material is None else draw.material, 0)
    if fragment["drawn_as"] != "triangle":
        return
    size = 1 + np.linalg.norm(frame.eye.position) + frame.bounds.radius
    triangle = eye_corners(frame, draw)[3 * source["triangle"]:3 * source["triangle"] + 3]
    corners = np.array([corner["eye"] for corner in fragment["corners"]])
    if not fragment["clipped"]:
        report.near("corners", corners, triangle, BOUND * size)
        window = [corner["window"][:2] for corner in fragment["corners"]]
        clip = np.hstack([triangle, np.ones((3, 1))]) @ frame.clip_from_eye.T
        report.near("window", window, (clip[:, :2] / clip[:, 3:] + 1) / 2 * [48, 32], 0.02)
    weights = np.array([corner["weight"] for corner in fragment["corners"]])
    report.near("sum of weights", weights.sum(), 1)
    for story in fragment["illuminations"]:
        check_illumination(frame, story, weights @ corners, report)


def check_illumination(frame: Frame, story: dict, position: np.ndarray, report: Report) -> None:
    """The formula of Blinn and Phong at a fragment, in eye space."""
    size = 1 + np.linalg.norm(frame.eye.position) + frame.bounds.radius
    shines = any(story["k_specular"][:3])
    # What the formula does not ask for is not told: the viewer where nothing shines, the place where all lights are directional, too.
    if shines or not all(light.directional for light in frame.lights):
        report.near("position", story["position"], position, BOUND * size)
    report.near("n", np.linalg.norm(story["n"]), 1)
    if shines:
        report.near("v", story["v"], -position / np.linalg.norm(position), 1e-3)
    report.near("ambient light", story["ambient_light"][:3], frame.ambient)
    base = np.array(story["emission"][:3]) + np.array(story["k_ambient"][:3]) * story["ambient_light"][:3]
    report.near("base", story["base"][:3], base)
    primary, secondary = base.copy(), np.zeros(3)
    report.near("number of lights", len(story["lights"]), len(frame.lights), 0)
    world = np.linalg.inv(frame.eye_from_world)
    point = (world[:3, :3] @ story["position"] + world[:3, 3])[None]
    for light, told in zip(frame.lights, story["lights"], strict=False):
        factor, towards = reaching(light, point)
        towards_eye = frame.eye_from_world[:3, :3] @ towards
        report.near("intensity", told["intensity"][:3], light.color, 1e-3)
        report.near("l", told["l"], towards_eye, 1e-3)
        report.near("weakening", told["weakening"], factor, 5e-3)
        report.near("n_dot_l", max(told["n_dot_l"], 0), max(np.array(story["n"]) @ towards_eye, 0), 1e-3)
        check_shares(story, told, shines, report)
        primary += told["diffuse"][:3]
        secondary += told["specular"][:3]
    report.near("primary", story["primary"][:3], primary, 1e-4)
    report.near("secondary", story["secondary"][:3], secondary, 1e-4)


def reaching(light: Light, point: np.ndarray) -> tuple[float, np.ndarray]:
    """How much of the light comes to a point, and from where."""
    factor, towards = weakened(light, point)
    if light.cutoff is None:
        return factor[0], towards[0]
    cosine = -(towards[0] @ light.direction)
    return factor[0] * (cosine**light.exponent if cosine >= math.cos(light.cutoff) else 0.0), towards[0]


def check_shares(story: dict, told: dict, shines: bool, report: Report) -> None:
    """k_d I N·L and k_s I (N·H)^n, from the vectors as they are told."""
    strength = np.array(told["intensity"][:3]) * told["weakening"]
    lit = told["n_dot_l"] > 0
    report.near("diffuse", told["diffuse"][:3], strength * max(told["n_dot_l"], 0) * story["k_diffuse"][:3], 1e-4)
    report.near("specular", told["specular"][:3], strength * story["k_specular"][:3] * told["power"] * lit, 1e-4)
    if not shines:
        return
    half = np.array(told["l"]) + story["v"]
    report.near("h", told["h"], half / np.linalg.norm(half), 1e-3)
    report.near("highlight", told["highlight"], np.array(story["n"]) @ told["h"], 1e-3)
    power = max(told["highlight"], 0)**story["shininess"] if lit else 0.0
    report.near("power", told["power"], power, 1e-3)


def check_units(fragment: dict, report: Report) -> None:
    for unit in fragment["textures"]:
        for level in unit["levels"]:
            texels = level["texels"]
            report.near("weights of texels", sum(texel["weight"] for texel in texels), 1)
            report.near("level", level["color"], sum(texel["weight"] * np.array(texel["color"]) for texel in texels), 2e-3)
        far = unit["second_level_weight"]
        colors = [np.array(level["color"]) for level in unit["levels"]]
        report.near("texel", unit["texel"], colors[0] if len(colors) == 1 else colors[0] * (1 - far) + colors[1] * far, 5e-3)


def encoded(color: list[float]) -> list[int]:
    clamped = np.clip(np.array(color[:3]), 0, 1)
    srgb = np.where(clamped <= 0.0031308, clamped * 12.92, 1.055 * clamped**(1 / 2.4) - 0.055)
    return np.round(srgb * 255).astype(int).tolist()


def check(program, lines: list[str]) -> int:
    rng, count = random.Random(3), 0
    for seed in range(1, 61):
        scene = RandomScene(seed)
        (program.folder / "s.glb").write_bytes(scene.glb.bytes())
        call = make_call(rng, "s.glb", scene.glb.tree)
        frame = next(iter(Frames(scene.glb, call)))
        pixel = triangle_in_view(rng, frame)
        if pixel is None:
            continue
        status, text, error = program("inspect", *call.words, "--quiet", "--json", "--pixel", f"{pixel[0]},{pixel[1]}")
        report = Report(lines, f"seed {seed}, pixel {pixel}")
        if status != 0:
            lines.append(f"seed {seed}: {error!r}")
            continue
        story = json.loads(text)
        report.near("clear", story["clear"]["color"], clear_color(frame, {"draws": [f["source"] for f in story["fragments"]]}), 1e-4)
        for fragment in story["fragments"]:
            if not fragment["source"]["backdrop"]:
                check_fragment(frame, fragment, report)
                check_units(fragment, report)
        report.near("rgba8", story["rgba8"][:3], encoded(story["color"]), 0)
        count += report.count
    return count
