"""Random calls of `barrido render` of a random scene: the words, and what they mean."""

import dataclasses
import math
import random

import numpy as np

from frames import Call
from light import Light
from pose import unit
from random_scenes import numbers

MIN_FILTERS = {"nearest": 9728, "linear": 9729, "nearest-mipmap-nearest": 9984, "linear-mipmap-nearest": 9985,
               "nearest-mipmap-linear": 9986, "linear-mipmap-linear": 9987}
SHADINGS = ["flat", "gouraud", "cheap-phong", "phong"]


def words_of(values: list[float]) -> str:
    return ",".join(repr(value) for value in values)


class RandomCall:
    """`call` for a file with so many cameras, animations and scenes. Cameras are those of the scene chosen."""

    def __init__(self, seed: int, path: str, tree: dict, cameras_of_scene: list[int]) -> None:
        self._rng = random.Random(seed)
        self._tree = tree
        self.call = Call(words=[], path=path)
        self.call.scene = self._rng.randrange(len(tree["scenes"])) if self._rng.random() < 0.3 else None
        if self.call.scene is not None:
            self._say("--scene", str(self.call.scene))
        index = tree.get("scene", 0) if self.call.scene is None else self.call.scene
        self._choose_view(cameras_of_scene[index])
        self._choose_moments()
        self._choose_lights()
        self._choose_surfaces()
        self._choose_colors()
        self._choose_names()
        self.call.words = [path, "-o", self.call.output, *self.call.words]

    def _say(self, *words: str) -> None:
        self.call.words += words

    def _maybe(self, chance: float) -> bool:
        return self._rng.random() < chance

    def _vector(self, option: str, size: float = 3.0) -> np.ndarray:
        values = numbers(self._rng, 3, -size, size)
        self._say(option, words_of(values))
        return np.array(values)

    def _number(self, option: str, low: float, high: float) -> float:
        value = round(self._rng.uniform(low, high), 3)
        self._say(option, repr(value))
        return value

    def _choose_view(self, cameras: int) -> None:
        view = self.call.view
        view.width, view.height = self._rng.choice([(64, 64), (90, 60), (40, 70)])
        self._say("--resolution", f"{view.width},{view.height}")
        placed = [self._maybe(0.15), self._maybe(0.15)]
        self._choose_cameras(cameras, 1 if any(placed) else cameras)
        if self._maybe(0.25):
            axis = self._rng.choice(["+X", "-X", "-Y", "+Z", "-Z", None])
            if axis:
                self._say("--up", axis)
                view.up = (1.0 if axis[0] == "+" else -1.0) * np.eye(3)["XYZ".index(axis[1])]
            else:
                view.up = self._vector("--up")
        if placed[0]:
            view.position = self._vector("--camera-position", 9)
        if placed[1]:
            view.focal_point = self._vector("--camera-focal-point")
        # A position alone means a view of one's own, unless a camera was named.
        if (view.position is not None or view.focal_point is not None) and self.call.cameras is None:
            view.ignore_cameras = True
        if self._maybe(0.15):
            view.view_angle = self._number("--camera-view-angle", 5, 120)
        elif self._maybe(0.15):
            view.orthographic_height = self._number("--orthographic-height", 0.5, 9)
        if self._maybe(0.15):
            view.view_up = self._vector("--camera-up")
        if self._maybe(0.3):
            view.azimuth = self._number("--azimuth", -360, 360)
        if self._maybe(0.3):
            view.elevation = self._number("--elevation", -90, 90)

    def _choose_cameras(self, cameras: int, most: int) -> None:
        if self._maybe(0.2):
            self._say("--camera-index", "none")
            self.call.view.ignore_cameras = True
        elif cameras and self._maybe(0.6):
            chosen = "all" if most > 1 and self._maybe(0.3) else self._rng.sample(range(cameras), self._rng.randint(1, most))
            self.call.cameras = chosen
            self._say("--camera-index", chosen if chosen == "all" else ",".join(map(str, chosen)))

    def _choose_moments(self) -> None:
        call, rng = self.call, self._rng
        animations = len(self._tree.get("animations", []))
        if animations and self._maybe(0.75):
            if self._maybe(0.5):
                call.animation = rng.randrange(animations)
                self._say("--animation", str(call.animation))
            if self._maybe(0.4):
                first = rng.randint(0, 5)
                call.frame_range = (first, first + rng.randint(0, 3))
                self._say("--frames", f"{call.frame_range[0]}:{call.frame_range[1]}")
                if self._maybe(0.7):
                    call.fps = self._number("--fps", 1, 10)
            else:
                call.time = self._number("--time", 0, 4)
        if call.frame_range is None and self._maybe(0.2):
            call.turntable = rng.randint(1, 4)
            self._say("--turntable", str(call.turntable))
        if self._maybe(0.3):
            call.shadings = rng.sample(SHADINGS, rng.randint(1, 2))
            self._say("--shading", ",".join(call.shadings))

    def _choose_lights(self) -> None:
        lights = self.call.lights
        if self._maybe(0.1):
            lights.none = True
            self._say("--no-lights")
        if self._maybe(0.25) and not lights.none:
            lights.user = [self._user_light() for _ in range(self._rng.randint(1, 3))]
        if self._maybe(0.1) and not lights.none:
            lights.off = sorted(self._rng.sample(range(3), self._rng.randint(1, 2)))
            self._say("--light-off", ",".join(str(i + 1) for i in lights.off))
        if self._maybe(0.2):
            lights.ambient = numbers(self._rng, 3, 0, 1)
            self._say("--ambient", words_of(lights.ambient))

    def _user_light(self) -> tuple[Light, bool]:
        rng = self._rng
        kind = rng.choice(["directional", "point", "spot"])
        words, with_eye = [kind], self._maybe(0.4)
        if with_eye or self._maybe(0.3):
            words.append("space=camera" if with_eye else "space=world")
        color, intensity = numbers(rng, 3, 0, 1), round(rng.uniform(-1, 2), 3)
        words += [f"color={words_of(color)}", f"intensity={intensity!r}"]
        light = Light(np.array(color) * intensity, np.zeros(3), directional=kind == "directional")
        if kind != "point":
            direction = numbers(rng, 3)
            words.append(f"dir={words_of(direction)}")
            light.direction = unit(np.array(direction))
        if kind == "directional":
            light.position, light.direction = -light.direction, None
        else:
            self._place(light, words)
        if kind == "spot":
            self._shape_cone(light, words)
        self._say("--light", ":".join(words))
        return light, with_eye

    def _place(self, light: Light, words: list[str]) -> None:
        position = numbers(self._rng, 3, -4, 4)
        words.append(f"pos={words_of(position)}")
        light.position = np.array(position)
        if self._maybe(0.5):
            light.attenuation = tuple(numbers(self._rng, 3, 0.1, 1))
            words.append(f"attenuation={words_of(list(light.attenuation))}")
        if self._maybe(0.5):
            light.range = round(self._rng.uniform(1, 9), 2)
            words.append(f"range={light.range!r}")

    def _shape_cone(self, light: Light, words: list[str]) -> None:
        outer = round(self._rng.uniform(10, 80), 2)
        if self._maybe(0.5):
            inner = round(self._rng.uniform(0, 0.9) * outer, 2)
            light.cone = (math.radians(inner), math.radians(outer))
            words.append(f"cone={inner!r},{outer!r}")
        else:
            light.cutoff, light.exponent = math.radians(outer), round(self._rng.uniform(0, 30), 2)
            words += [f"cutoff={outer!r}", f"exponent={light.exponent!r}"]

    def _choose_surfaces(self) -> None:
        surfaces = self.call.surfaces
        if self._maybe(0.1):
            surfaces.textures = False
            self._say("--no-textures")
        if self._maybe(0.2):
            surfaces.phong = True
            self._say("--lighting", "phong")
        if self._maybe(0.15):
            surfaces.material = self._material()
        if self._maybe(0.15):
            self.call.cull = self._rng.choice(["none", "back", "front"])
            self._say("--cull", self.call.cull)
        if self._maybe(0.3):
            self.call.crease = self._number("--crease-angle", 0, 180)
        if self._maybe(0.1):
            name = self._rng.choice(list(MIN_FILTERS))
            self.call.min_filter = MIN_FILTERS[name]
            self._say("--min-filter", name)
        if self._maybe(0.2):
            self.call.exact_order = True
            self._say("--transparency", "exact")
        if self._maybe(0.05):
            self.call.wireframe = True
            self._say("--wireframe")

    def _material(self) -> dict:
        rng, given = self._rng, {}
        for name in ("color", "ambient", "diffuse", "specular", "emission"):
            if self._maybe(0.3):
                given[name] = numbers(rng, 3, 0, 1)
        for name, most in (("metallic", 1), ("roughness", 1), ("shininess", 200)):
            if self._maybe(0.3):
                given[name] = round(rng.uniform(0, most), 3)
        given = given or {"roughness": 0.25}
        self._say("--material", ":".join(f"{name}={words_of(value) if isinstance(value, list) else value}"
                                         for name, value in given.items()))
        return given

    def _choose_colors(self) -> None:
        call, rng = self.call, self._rng
        if self._maybe(0.2):
            call.surfaces.linear = False
            self._say("--color-management", "none")
        if self._maybe(0.2):
            call.exposure = self._number("--exposure", -3, 3)
        if self._maybe(0.2):
            call.reinhard = True
            self._say("--tone-map", "reinhard")
        call.surfaces.float_frame = call.surfaces.linear or call.exposure != 0 or call.reinhard
        if self._maybe(0.3):
            call.background = numbers(rng, 3, 0, 1)
            self._say("--background", words_of(call.background))
        if self._maybe(0.2):
            call.fog_color = numbers(rng, 3, 0, 1) if self._maybe(0.5) else []
            self._say("--fog", ":".join(["exp:0.1", *([words_of(call.fog_color)] if call.fog_color else [])]))

    def _choose_names(self) -> None:
        """Whatever differs from frame to frame must be in the name; other things may be."""
        call, rng = self.call, self._rng
        needed = [name for name, differs in (("shading", len(call.shadings) > 1), ("camera", call.cameras is not None),
                                             ("frame", call.turntable > 1 or call.frame_range is not None)) if differs]
        placeholders = needed + rng.sample(["model", "shading", "camera", "frame", "view", "folder"], rng.randint(0, 2))
        pieces = [rng.choice(["frame", "frame:03", "frame:01"]) if name == "frame" else name for name in placeholders]
        call.output = rng.choice(["out/", "", "a{{b}}"]) + "-".join("{" + piece + "}" for piece in pieces) + "x.png"


def cameras_by_scene(tree: dict, nodes_of_scene: list[list[int]]) -> list[int]:
    return [sum("camera" in tree["nodes"][node] for node in nodes) for nodes in nodes_of_scene]


def with_words(call: Call, *words: str) -> Call:
    return dataclasses.replace(call, words=[*call.words, *words])
