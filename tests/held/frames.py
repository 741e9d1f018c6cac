"""The frames of a call of `barrido render`: which there are, their names, and what each draws in which order (docs/scene.md)."""

import dataclasses
import re
from collections.abc import Iterator

import numpy as np

from glb import Glb
from light import Light, LightChoice, ambient_of, chosen_lights, file_lights, metered
from pointers import at_moment
from pose import Pose, Vertices
from surface import Materials, Surface, SurfaceChoice, linear
from view import Bounds, Choice, Eye, bounds_of, choose_eye, clip_from_eye, eye_from_world, world_points

LINES, LINE_LOOP, LINE_STRIP = 1, 2, 3
TRIANGLES, STRIP, FAN = 4, 5, 6


@dataclasses.dataclass
class Call:
    """A call of one file, as words and as what they mean."""

    words: list[str]
    path: str
    output: str = "out.png"
    scene: int | None = None
    shadings: list[str] = dataclasses.field(default_factory=lambda: ["phong"])
    cameras: list[int] | str | None = None  # "all", or their numbers
    turntable: int = 0
    frame_range: tuple[int, int] | None = None
    fps: float = 30.0
    time: float | None = None
    animation: int | None = None
    view: Choice = dataclasses.field(default_factory=Choice)
    lights: LightChoice = dataclasses.field(default_factory=LightChoice)
    surfaces: SurfaceChoice = dataclasses.field(default_factory=SurfaceChoice)
    background: list[float] | None = None
    fog_color: list[float] | None = None  # Of --fog; empty: the background's
    exposure: float = 0.0
    reinhard: bool = False
    cull: str | None = None
    crease: float | None = None  # Degrees
    min_filter: int | None = None
    wireframe: bool = False
    exact_order: bool = False  # Of transparent fragments


@dataclasses.dataclass
class Draw:
    node: int
    mesh: int
    primitive: int
    material: int | None
    source: dict  # The primitive
    material_source: dict
    vertices: Vertices
    corners: list[int]  # Vertices of the triangles, or of the points or lines
    surface: Surface
    mirrored: bool
    values: list[np.ndarray]  # Of the file's accessors
    order: list[int] | None = None  # Of the triangles, where blended


@dataclasses.dataclass
class Frame:
    name: str
    label: str
    shading: str
    eye: Eye
    eye_from_world: np.ndarray
    clip_from_eye: np.ndarray
    bounds: Bounds
    lights: list[Light]
    ambient: list[float]
    background: np.ndarray
    fog_color: np.ndarray | None
    draws: list[Draw]


def nodes_of_scene(tree: dict, index: int | None) -> list[int]:
    """All nodes below the roots, in the file's order."""
    reached: set[int] = set()
    waiting = list(tree["scenes"][tree.get("scene", 0) if index is None else index]["nodes"])
    while waiting:
        node = waiting.pop()
        reached.add(node)
        waiting += tree["nodes"][node].get("children", [])
    return sorted(reached)


def corners_of(mode: int, indices: list[int]) -> list[int]:
    """The vertices of the whole triangles of a surface, as OpenGL winds them; of whole points and lines."""
    count = len(indices)
    if mode == LINES:
        return indices[:count - count % 2]
    if mode in (LINE_LOOP, LINE_STRIP):
        return indices if count >= 2 else []
    if mode == TRIANGLES:
        return indices[:count - count % 3]
    if mode == STRIP:
        faces = [(i, i + 1, i + 2) if i % 2 == 0 else (i + 1, i, i + 2) for i in range(count - 2)]
    elif mode == FAN:
        faces = [(0, i + 1, i + 2) for i in range(count - 2)]
    else:
        return indices
    return [indices[i] for face in faces for i in face]


def expanded(template: str, values: dict[str, str], frame: int) -> str:
    """{name} and {frame:04}; {{ and }} are braces."""

    def replaced(match: re.Match) -> str:
        inside = match.group(0)[1:-1]
        if match.group(0) in ("{{", "}}"):
            return match.group(0)[0]
        return str(frame).zfill(int(inside[7:])) if inside.startswith("frame:") else values[inside]

    return re.sub(r"\{\{|\}\}|\{[^}]*\}", replaced, template)


class Frames:
    """The frames of a call of the file that `glb` describes."""

    def __init__(self, glb: Glb, call: Call) -> None:
        self._glb, self._tree, self._call = glb, glb.tree, call
        self._materials = Materials(glb, call.surfaces)
        self._nodes = nodes_of_scene(self._tree, call.scene)
        self._scene = self._tree["scenes"][self._tree.get("scene", 0) if call.scene is None else call.scene]
        self._camera_nodes = [node for node in self._nodes if "camera" in self._tree["nodes"][node]]
        self._animation = call.animation
        if self._animation is None and (call.frame_range or call.time is not None):
            self._animation = 0
        self._bounds = self._find_bounds()
        standing = Pose(glb)
        # Exposure looks at vertices as the file has them, neither morphed nor skinned.
        # Every so many are asked, and those of them count that are drawn.
        parts = [self._unposed(standing, node, primitive) for node, _, _, primitive in self._primitives()]
        drawn = [self._is_drawn(primitive, len(part.positions))
                 for part, (_, _, _, primitive) in zip(parts, self._primitives(), strict=True)]
        self._meter = metered(file_lights(self._tree, self._nodes, standing), parts, drawn)

    def _primitives(self) -> Iterator[tuple[int, int, int, dict]]:
        for node in self._nodes:
            if "mesh" in self._tree["nodes"][node]:
                mesh = self._tree["nodes"][node]["mesh"]
                for i, primitive in enumerate(self._tree["meshes"][mesh]["primitives"]):
                    yield node, mesh, i, primitive

    def _unposed(self, pose: Pose, node: int, primitive: dict) -> Vertices:
        positions = self._glb.values[primitive["attributes"]["POSITION"]]
        normals = primitive["attributes"].get("NORMAL")
        return Vertices(pose.world[node], positions, None if normals is None else self._glb.values[normals], np.ones(0))

    def _corners(self, primitive: dict, count: int) -> list[int]:
        indices = self._glb.values[primitive["indices"]][:, 0].astype(int).tolist() if "indices" in primitive else list(range(count))
        return corners_of(primitive.get("mode", TRIANGLES), indices)

    def _is_drawn(self, primitive: dict, count: int) -> np.ndarray:
        drawn = np.zeros(count, bool)
        drawn[sorted(set(self._corners(primitive, count)))] = True
        return drawn

    def _drawn(self, vertices: Vertices, primitive: dict) -> Vertices:
        """Those that belong to a point, a line or a triangle."""
        used = sorted(set(self._corners(primitive, len(vertices.positions))))
        normals = None if vertices.normals is None else vertices.normals[used]
        return dataclasses.replace(vertices, positions=vertices.positions[used], normals=normals)

    def _find_bounds(self) -> Bounds:
        """Around the scene as it stands, or at nine moments of its animation."""
        poses = [Pose(self._glb)]
        if self._animation is not None:
            animation = self._tree["animations"][self._animation]
            duration = max(self._glb.values[sampler["input"]].max() for sampler in animation["samplers"])
            poses = [Pose(self._glb, self._animation, duration * i / 8) for i in range(9)]
        parts = [self._drawn(pose.vertices(node, primitive), primitive)
                 for pose in poses for node, _, _, primitive in self._primitives()]
        return bounds_of(world_points(parts), self._call.view.up)

    def _moments(self) -> list[tuple[int, float, float]]:
        """Number, time and azimuth."""
        if self._call.frame_range:
            first, last = self._call.frame_range
            return [(n, n / self._call.fps, 0.0) for n in range(first, last + 1)]
        count = max(1, self._call.turntable)
        return [(n, self._call.time or 0.0, 360.0 * n / count) for n in range(count)]

    def __iter__(self) -> Iterator[Frame]:
        cameras: list[int | None] = [None]
        if self._call.cameras is not None:
            cameras = list(range(len(self._camera_nodes)) if self._call.cameras == "all" else self._call.cameras)
        for camera in cameras:
            for shading in self._call.shadings:
                for number, time, azimuth in self._moments():
                    yield self._frame(camera, shading, number, time, azimuth)

    def _name(self, camera: int | None, shading: str, number: int) -> str:
        model = self._call.path.rsplit("/", 1)[-1].rsplit(".", 1)[0]
        values = {"model": model, "shading": shading, "camera": "auto" if camera is None else str(camera), "view": "picture",
                  "frame": str(number), "folder": self._call.path.rpartition("/")[0].lstrip("/")}
        return expanded(self._call.output, values, number)

    def _label(self, camera: int | None, shading: str, number: int) -> str:
        """Of sheets and hashes: what differs from frame to frame."""
        label = self._call.path.rsplit("/", 1)[-1].rsplit(".", 1)[0] + "/" + shading
        label += f"/camera{camera}" if camera is not None else ""
        several = self._call.turntable > 1 or (self._call.frame_range and self._call.frame_range[0] < self._call.frame_range[1])
        return label + (f"/frame{number}" if several else "")

    def _frame(self, camera: int | None, shading: str, number: int, time: float, azimuth: float) -> Frame:
        pose = Pose(self._glb, self._animation, time)
        moved = at_moment(self._glb, self._animation, time)
        materials = self._materials if moved is self._glb else Materials(moved, self._call.surfaces)
        choice = dataclasses.replace(self._call.view, camera=camera, azimuth=self._call.view.azimuth + azimuth)
        eye = choose_eye(moved.tree, self._camera_nodes, pose, self._bounds, choice)
        view = eye_from_world(eye, self._bounds)
        background = self._background()
        return Frame(self._name(camera, shading, number), self._label(camera, shading, number), shading, eye, view, clip_from_eye(eye, choice.width / choice.height),
                     self._bounds,
                     chosen_lights(moved.tree, self._nodes, pose, self._call.lights, np.linalg.inv(view), self._meter),
                     ambient_of(self._scene, self._call.lights), background, self._fog_color(background),
                     self._ordered(self._draws(pose, materials, moved.tree), view, eye.half_height is not None))

    def _shown(self, color: np.ndarray) -> np.ndarray:
        """What the frame must hold for this colour to be seen: the display transform's inverse."""
        if not self._call.surfaces.float_frame:
            return color
        inside = linear(color) if self._call.surfaces.linear else color
        if self._call.reinhard:
            inside = np.where(inside < 0.999, inside / np.maximum(1 - inside, 1e-9), 999.0)
        return inside * 2.0**-self._call.exposure

    def _background(self) -> np.ndarray:
        own = self._scene.get("extras", {}).get("barrido", {})
        if self._call.background is None and "background" in own:
            return np.array((own["background"] + [1.0])[:4])
        seen = (self._call.background or [0.2, 0.2, 0.2]) + [1.0]
        return np.append(self._shown(np.array(seen[:3])), seen[3])

    def _fog_color(self, background: np.ndarray) -> np.ndarray | None:
        if self._call.fog_color is not None:
            return self._shown(np.array(self._call.fog_color)) if self._call.fog_color else background[:3]
        fog = self._scene.get("extras", {}).get("barrido", {}).get("fog")
        return np.array(fog["color"]) if fog else None

    def _draws(self, pose: Pose, materials: Materials, tree: dict) -> list[Draw]:
        draws = []
        for node, mesh, i, primitive in self._primitives():
            vertices = pose.vertices(node, primitive)
            mode, material = primitive.get("mode", TRIANGLES), primitive.get("material")
            is_surface = mode in (TRIANGLES, STRIP, FAN)
            has_normals = vertices.normals is not None or is_surface
            surface = materials.surface(material, has_normals, "COLOR_0" in primitive["attributes"])
            source = tree["materials"][material] if material is not None else {}
            # A skin's joints carry the vertices, so that the node cannot mirror them.
            mirrored = np.linalg.det(vertices.world_from_object[:3, :3]) < 0
            draws.append(Draw(node, mesh, i, material, primitive, source, vertices, self._rewound(node, primitive, vertices), surface, mirrored,
                              self._glb.values))
        return draws

    def _rewound(self, node: int, primitive: dict, vertices: Vertices) -> list[int]:
        """Triangles of a skin whose joints mirror two of their corners are wound the other way."""
        corners = self._corners(primitive, len(vertices.positions))
        if vertices.mirrored is None or primitive.get("mode", TRIANGLES) not in (TRIANGLES, STRIP, FAN):
            return corners
        for i in range(0, len(corners), 3):
            if vertices.mirrored[corners[i:i + 3]].sum() >= 2:
                corners[i], corners[i + 1] = corners[i + 1], corners[i]
        return corners

    def _ordered(self, draws: list[Draw], view: np.ndarray, parallel: bool) -> list[Draw]:
        """Blended ones last; the triangles of all of them by their middles, farthest first, or as they are."""
        opaque = [draw for draw in draws if draw.material_source.get("alphaMode") != "BLEND"]
        blended = [draw for draw in draws if draw.material_source.get("alphaMode") == "BLEND"]
        for draw in blended:
            if draw.source.get("mode", TRIANGLES) in (TRIANGLES, STRIP, FAN) and not self._call.exact_order:
                middles = draw.vertices.positions[draw.corners].reshape(-1, 3, 3).mean(axis=1)
                draw.order = sorted(range(len(middles)), key=lambda i, d=distances(view, draw, middles, parallel): -d[i])
        return opaque + blended


def distances(view: np.ndarray, draw: Draw, points: np.ndarray, parallel: bool) -> np.ndarray:
    """From the eye, or along the view where all rays are parallel."""
    matrix = view @ draw.vertices.world_from_object
    seen = points @ matrix[:3, :3].T + matrix[:3, 3]
    return -seen[:, 2] if parallel else np.linalg.norm(seen, axis=1)
