"""The eye of a frame: cameras of glTF 2.0 (section 3.10), and what Barrido chooses beyond them (docs/scene.md)."""

import dataclasses
import math

import numpy as np

from pose import Pose, Vertices, unit

SLICES = 64


@dataclasses.dataclass
class Choice:
    """What a call asks of the eye; None: not given."""

    width: int = 1280
    height: int = 720
    camera: int | None = None  # Among the scene's
    ignore_cameras: bool = False
    position: np.ndarray | None = None
    focal_point: np.ndarray | None = None
    view_angle: float | None = None
    up: np.ndarray = dataclasses.field(default_factory=lambda: np.array([0.0, 1.0, 0.0]))
    view_up: np.ndarray | None = None
    orthographic_height: float | None = None
    azimuth: float = 0.0
    elevation: float = 0.0


@dataclasses.dataclass
class Bounds:
    center: np.ndarray
    radius: float
    rings: list[tuple[float, float]]  # Radius, height about the upright axis


@dataclasses.dataclass
class Eye:
    position: np.ndarray
    focal_point: np.ndarray
    up: np.ndarray
    fov: float = math.radians(30)
    half_height: float | None = None  # Orthographic
    near: float = 0.0
    far: float = 0.0  # 0: infinite


def turned(vector: np.ndarray, axis: np.ndarray, degrees: float) -> np.ndarray:
    """By the right-hand rule about a unit axis: the part across it goes round."""
    angle = math.radians(degrees)
    along = axis * (axis @ vector)
    across = vector - along
    return along + across * math.cos(angle) + np.cross(axis, across) * math.sin(angle)


def upright_axes(up: np.ndarray) -> np.ndarray:
    """Columns: right, up and front of a scene; the smallest turn takes +Y to `up`, half a turn about X takes it to −Y."""
    up = unit(up)
    axis = np.cross([0, 1, 0], up)
    if np.linalg.norm(axis) < 1e-12:
        return np.eye(3) if up[1] > 0 else np.diag([1.0, -1.0, -1.0])
    angle = math.degrees(math.atan2(np.linalg.norm(axis), up[1]))
    return np.array([turned(v, unit(axis), angle) for v in np.eye(3)]).T


def bounds_of(points: np.ndarray, up: np.ndarray) -> Bounds:
    """A sphere about the middle of the bounding box, and the body that turning about the upright axis fills: in each of 64
    slices of the sphere the largest radius, at the lowest and at the highest vertex of the slice."""
    if len(points) == 0:
        return Bounds(np.zeros(3), 1.0, [])
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    offsets = points - center
    radius = float(np.sqrt((offsets**2).sum(axis=1).max()))
    smallest = float(np.linalg.norm(center)) * 1e-6
    if radius <= smallest:
        radius = smallest if smallest > 0 else 1.0
    heights = offsets @ unit(up)
    across = np.sqrt(((offsets - np.outer(heights, unit(up)))**2).sum(axis=1))
    slices = np.clip(np.floor((heights / radius + 1) / 2 * SLICES), 0, SLICES - 1)
    rings = []
    for number in np.unique(slices):
        inside = slices == number
        rings += [(across[inside].max(), heights[inside].min()), (across[inside].max(), heights[inside].max())]
    return Bounds(center, radius, rings)


def framing_distance(bounds: Bounds, fov: float, aspect: float) -> float:
    """From where every point of every ring is between the four planes of the view, and a twentieth more."""
    tan_y = math.tan(fov / 2)
    tan_x = tan_y * aspect
    elevation = math.radians(18)
    towards = np.array([0.0, math.sin(elevation), math.cos(elevation)])  # The eye's direction: x right, y up, z front
    picture_up = np.array([0.0, math.cos(elevation), -math.sin(elevation)])
    distance = bounds.radius
    for radius, height in bounds.rings:
        for normal in (np.array([1.0, 0, 0]) / tan_x, picture_up / tan_y, -picture_up / tan_y):
            # A point p is inside when normal·p ≤ distance − towards·p; of a ring, (normal + towards)·p is at most this.
            sum_ = normal + towards
            distance = max(distance, radius * math.hypot(sum_[0], sum_[2]) + height * sum_[1])
    return 1.05 * distance


def framed_eye(bounds: Bounds, choice: Choice) -> Eye:
    """From the front, 25° to the right and 18° above."""
    fov = math.radians(choice.view_angle if choice.view_angle is not None else 30)
    right, up, front = upright_axes(choice.up).T
    direction = turned(turned(front, right, -18), up, 25)
    distance = framing_distance(bounds, fov, choice.width / choice.height)
    return Eye(bounds.center + direction * distance, bounds.center, unit(choice.up))


def file_eye(camera: dict, world: np.ndarray, bounds: Bounds) -> Eye:
    """At the node, looking along its −Z at the depth of the scene's middle."""
    position, forward = world[:3, 3], unit(-world[:3, 2])
    depth = (bounds.center - position) @ forward
    eye = Eye(position, position + forward * (depth if depth > 0 else bounds.radius), unit(world[:3, 1]))
    lens = camera[camera["type"]]
    if camera["type"] == "orthographic":
        eye.half_height = abs(lens["ymag"])
    else:
        eye.fov = lens["yfov"]
    eye.near, eye.far = lens.get("znear", 0.0), lens.get("zfar", 0.0)
    return eye


def across(vector: np.ndarray, forward: np.ndarray) -> np.ndarray:
    return unit(vector - forward * (vector @ forward))


def forward_of(eye: Eye, bounds: Bounds) -> np.ndarray:
    for target in (eye.focal_point, bounds.center):
        if np.linalg.norm(target - eye.position) > 0:
            return unit(target - eye.position)
    return np.array([0.0, 0, -1])


def override(eye: Eye, choice: Choice) -> None:
    if choice.position is not None:
        eye.position = choice.position
    if choice.focal_point is not None:
        eye.focal_point = choice.focal_point
    if choice.position is not None or choice.focal_point is not None:
        eye.up = unit(choice.up)
    if choice.view_angle is not None:
        eye.fov, eye.half_height = math.radians(choice.view_angle), None
    if choice.view_up is not None:
        eye.up = unit(choice.view_up)
    if choice.orthographic_height is not None:
        eye.half_height = choice.orthographic_height / 2


def orbit(eye: Eye, choice: Choice) -> None:
    """Azimuth about the scene's up direction, the eye to the right; then elevation, the eye upwards."""
    if choice.azimuth:
        axis = unit(choice.up)
        eye.position = eye.focal_point + turned(eye.position - eye.focal_point, axis, choice.azimuth)
        eye.up = turned(eye.up, axis, choice.azimuth)
    if choice.elevation:
        forward = unit(eye.focal_point - eye.position)
        up = across(eye.up, forward)
        right = np.cross(forward, up)
        eye.position = eye.focal_point + turned(eye.position - eye.focal_point, right, -choice.elevation)
        eye.up = turned(up, right, -choice.elevation)


def set_planes(eye: Eye, bounds: Bounds, choice: Choice, from_file: bool) -> None:
    """`from_file`: the eye has planes. They stay, unless the eye was taken elsewhere or the lens exchanged for parallel rays: then those of the file move
    apart as far as the scene asks for. Without a file's they lie just around the scene."""
    moved = choice.position is not None or choice.focal_point is not None or choice.orthographic_height is not None
    if from_file and not moved:
        return
    depth = (bounds.center - eye.position) @ forward_of(eye, bounds)
    reach = 1.02 * bounds.radius
    far = depth + reach if depth + reach > 0 else reach
    near = max(depth - reach, far / 1000)
    if not from_file:
        eye.near, eye.far = near, far
        return
    if eye.far > 0 or eye.half_height is not None:
        eye.far = max(eye.far, far)
    eye.near = min(eye.near, near)


def choose_eye(tree: dict, cameras: list[int], pose: Pose, bounds: Bounds, choice: Choice) -> Eye:
    """`cameras`: the scene's nodes with a camera."""
    from_file = choice.camera is not None or (bool(cameras) and not choice.ignore_cameras)
    if from_file:
        node = cameras[choice.camera or 0]
        eye = file_eye(tree["cameras"][tree["nodes"][node]["camera"]], pose.world[node], bounds)
    else:
        eye = framed_eye(bounds, choice)
    override(eye, choice)
    orbit(eye, choice)
    # A parallel view that is given an angle may begin at the eye, where a perspective one cannot.
    set_planes(eye, bounds, choice, from_file and (eye.near > 0 or eye.half_height is not None))
    return eye


def eye_from_world(eye: Eye, bounds: Bounds) -> np.ndarray:
    forward = forward_of(eye, bounds)
    up = across(eye.up, forward)
    matrix = np.eye(4)
    matrix[:3, :3] = [np.cross(forward, up), up, -forward]
    matrix[:3, 3] = -matrix[:3, :3] @ eye.position
    return matrix


def clip_from_eye(eye: Eye, aspect: float) -> np.ndarray:
    """Section 3.10.3: perspective, with or without an end, and orthographic."""
    near, far = eye.near, eye.far
    matrix = np.zeros((4, 4))
    if eye.half_height is not None:
        matrix[0, 0], matrix[1, 1] = 1 / (eye.half_height * aspect), 1 / eye.half_height
        matrix[2, 2:] = 2 / (near - far), (far + near) / (near - far)
        matrix[3, 3] = 1
        return matrix
    matrix[0, 0], matrix[1, 1] = 1 / (aspect * math.tan(eye.fov / 2)), 1 / math.tan(eye.fov / 2)
    matrix[2, 2:] = ((far + near) / (near - far), 2 * far * near / (near - far)) if far > 0 else (-1, -2 * near)
    matrix[3, 2] = -1
    return matrix


def world_points(parts: list[Vertices]) -> np.ndarray:
    """All positions in the world."""
    points = [part.positions @ part.world_from_object[:3, :3].T + part.world_from_object[:3, 3] for part in parts]
    return np.concatenate(points) if points else np.zeros((0, 3))
