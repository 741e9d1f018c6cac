"""Compares a frame as the second implementation has it with the one that Barrido would have drawn."""

import math

import numpy as np

from frames import FAN, STRIP, TRIANGLES, Call, Draw, Frame, corners_of, distances
from light import Light
from pose import carried, matrix_of
from surface import FILTERS, WRAPS, Unit

# Barrido reckons in floats: relative to the size of what is reckoned with.
BOUND = 3e-5
SHADINGS = {"flat": 0, "gouraud": 1, "cheap-phong": 2, "phong": 3}
CULL = {"none": 0, "back": 1, "front": 2}


class Differences:
    """What differs, and how much was looked at."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.place = ""
        self.checks = self.numbers = self.skipped = 0

    def add(self, text: str) -> None:
        self.lines.append(f"{self.place}: {text}")

    def expect(self, fine: bool, text: str) -> None:
        self.checks += 1
        if not fine:
            self.add(text)

    def near(self, what: str, theirs, ours, bound: float | np.ndarray = BOUND) -> bool:
        """Within `bound`, relative to the larger of 1 and the number itself."""
        theirs, ours = np.asarray(theirs, dtype=np.float64), np.asarray(ours, dtype=np.float64)
        self.checks += 1
        self.numbers += ours.size
        if theirs.shape != ours.shape:
            self.add(f"{what}: shape {theirs.shape}, not {ours.shape}")
            return False
        bad = ~(np.abs(theirs - ours) <= bound * np.maximum(np.abs(ours), 1))
        if bad.any():
            first = tuple(np.argwhere(bad)[0]) if ours.ndim else ()
            self.add(f"{what}{list(map(int, first))}: {theirs[first]}, not {ours[first]}")
        return not bad.any()


def rows(values: list[float], columns: int) -> np.ndarray:
    return np.array(values, dtype=np.float64).reshape(-1, columns)


def compare_light(what: str, light: Light, theirs: dict, size: float, differences: Differences) -> None:
    differences.near(f"{what} color", theirs["diffuse"][:3], light.color, BOUND * max(1, np.abs(light.color).max()))
    differences.near(f"{what} specular", theirs["specular"][:3], theirs["diffuse"][:3], 0)
    differences.near(f"{what} kind", theirs["position"][3], 0 if light.directional else 1, 0)
    differences.near(f"{what} position", theirs["position"][:3], light.position, BOUND * (1 if light.directional else size))
    if light.directional:
        return
    differences.near(f"{what} attenuation", theirs["attenuation"], light.attenuation)
    differences.near(f"{what} range", theirs["range"], light.range)
    if light.direction is not None:
        differences.near(f"{what} direction", theirs["spot_direction"], light.direction)
    cone = light.cone or (math.pi, math.pi)
    differences.near(f"{what} inner", theirs["spot_inner_cos"], math.cos(cone[0]))
    differences.near(f"{what} outer", theirs["spot_outer_cos"], math.cos(cone[1]))
    differences.near(f"{what} cutoff", theirs["spot_cutoff_deg"], 180 if light.cutoff is None else math.degrees(light.cutoff))
    differences.near(f"{what} exponent", theirs["spot_exponent"], light.exponent)


def compare_lights(frame: Frame, theirs: dict, size: float, differences: Differences) -> None:
    differences.near("ambient", theirs["ambient"], frame.ambient)
    differences.expect(len(theirs["lights"]) == len(frame.lights), f"{len(theirs['lights'])} lights, not {len(frame.lights)}")
    for i, (light, other) in enumerate(zip(frame.lights, theirs["lights"], strict=False)):
        compare_light(f"light {i}", light, other, size, differences)


def compare_eye_lights(frame: Frame, draw: dict, size: float, differences: Differences) -> None:
    """The lights as the draw has them."""
    turn = frame.eye_from_world[:3, :3]
    differences.near("ambient of the draw", draw["scene_ambient"][:3], frame.ambient)
    for i, (light, other) in enumerate(zip(frame.lights, draw["lights"], strict=False)):
        place = turn @ light.position + (0 if light.directional else frame.eye_from_world[:3, 3])
        differences.near(f"light {i} in eye space", other["position"][:3], place, BOUND * size)
        differences.near(f"light {i} of the draw", other["diffuse"][:3], light.color, BOUND * max(1, np.abs(light.color).max()))
        if light.direction is not None:
            differences.near(f"direction of light {i} in eye space", other["spot_direction"], turn @ light.direction)


def compare_frame(call: Call, frame: Frame, theirs: dict, differences: Differences) -> None:
    center = np.linalg.norm(frame.bounds.center)
    size = max(1.0, center + frame.bounds.radius + np.linalg.norm(frame.eye.position))
    differences.near("eye's turn", matrix_of(theirs["eye_from_world"])[:3, :3], frame.eye_from_world[:3, :3])
    differences.near("eye's place", matrix_of(theirs["eye_from_world"])[:3, 3], frame.eye_from_world[:3, 3], BOUND * size)
    compare_projection(frame, matrix_of(theirs["clip_from_eye"]), differences)
    differences.near("background", theirs["clear_color"], clear_color(frame, theirs), 1e-4)
    differences.near("exposure", theirs["exposure_scale"], 2.0**call.exposure if call.surfaces.float_frame else 1)
    differences.expect(theirs["tone_map"] == int(call.reinhard), "tone map")
    compare_lights(frame, theirs, size, differences)
    pieces = [draw for draw in theirs["draws"] if not draw["backdrop"]]
    if not call.exact_order:
        compare_blended(frame, [piece for piece in pieces if piece["blend"]], size, differences)
    draws = whole_draws(pieces)
    order = [(draw["node"], draw["primitive"]) for draw in draws]
    expected = [(draw.node, draw.primitive) for draw in frame.draws]
    differences.expect(same_order(frame, order, expected), f"order of draws: {order}, not {expected}")
    by_place = {(draw.node, draw.primitive): draw for draw in frame.draws}
    for other in draws:
        if (other["node"], other["primitive"]) not in by_place:
            continue
        draw = by_place[other["node"], other["primitive"]]
        differences.place = f"{frame.name}, node {draw.node}, primitive {draw.primitive}"
        compare_draw(call, frame, draw, other, size, differences)


def clear_color(frame: Frame, theirs: dict) -> np.ndarray:
    """Multiplied by its alpha where something is blended with it or cut out before it."""
    mixed = any(draw.material_source.get("alphaMode", "OPAQUE") != "OPAQUE" for draw in frame.draws)
    if not mixed or any(draw["backdrop"] for draw in theirs["draws"]):
        return frame.background
    return np.append(frame.background[:3] * frame.background[3], frame.background[3])


def whole_draws(pieces: list[dict]) -> list[dict]:
    """Blended draws are cut into pieces where others lie between their triangles."""
    whole: dict[tuple, dict] = {}
    for piece in pieces:
        place = (piece["node"], piece["primitive"])
        if place in whole:
            whole[place]["indices"] = whole[place]["indices"] + piece["indices"]
        else:
            whole[place] = dict(piece)
    return list(whole.values())


def compare_blended(frame: Frame, pieces: list[dict], size: float, differences: Differences) -> None:
    """The triangles of all pieces, one after the other, come nearer and nearer; points and lines stay together."""
    parallel = frame.eye.half_height is not None
    last = np.inf
    for piece in pieces:
        matrix = matrix_of(piece["eye_from_object"])
        points = rows(piece["position"], 3)
        points = points @ matrix[:3, :3].T + matrix[:3, 3]
        if piece["mode"] in (TRIANGLES, STRIP, FAN) and piece["indices"]:
            middles = points[piece["indices"]].reshape(-1, 3, 3).mean(axis=1)
        else:
            continue
        far = -middles[:, 2] if parallel else np.linalg.norm(middles, axis=1)
        allowed = 20 * BOUND * max(size, float(np.abs(points).max()))
        falls = np.diff(np.concatenate([[min(last, 1e30)], far])) <= allowed
        differences.expect(bool(falls.all()), "blended triangles are not in their order")
        last = far[-1]


def compare_projection(frame: Frame, theirs: np.ndarray, differences: Differences) -> None:
    ours = frame.clip_from_eye
    differences.near("projection's nought", theirs[ours == 0], ours[ours == 0], 0)
    differences.near("projection", theirs[ours != 0] / ours[ours != 0], np.ones(np.count_nonzero(ours)))


def same_order(frame: Frame, order: list, expected: list) -> bool:
    """Of the opaque draws; the blended ones come in any order, as their triangles say."""
    if order == expected:
        return True
    if sorted(order) != sorted(expected):
        return False
    opaque = [(draw.node, draw.primitive) for draw in frame.draws if draw.material_source.get("alphaMode") != "BLEND"]
    return order[:len(opaque)] == opaque


def compare_draw(call: Call, frame: Frame, draw: Draw, theirs: dict, size: float, differences: Differences) -> None:
    differences.expect((theirs["mesh"], theirs["material"]) == (draw.mesh, -1 if draw.material is None else draw.material), "origin")
    compare_state(call, frame, draw, theirs, differences)
    compare_eye_lights(frame, theirs, size, differences)
    compare_surface(call, draw, theirs, differences)
    is_surface = draw.source.get("mode", TRIANGLES) in (TRIANGLES, STRIP, FAN)
    indices = theirs["indices"] or list(range(theirs["vertex_count"]))
    their_corners = corners_of(theirs["mode"], indices)
    corners = draw.corners
    if len(corners) != len(their_corners):
        differences.add(f"{len(their_corners)} corners, not {len(corners)}")
        return
    if draw.order is not None and corners:
        corners = np.array(corners).reshape(-1, 3)[draw.order].flatten().tolist()
    if not is_surface:
        differences.expect(theirs["mode"] == draw.source["mode"], "mode")
    if compare_vertices(call, frame, draw, theirs, corners, their_corners, size, differences):
        compare_arrays(draw, theirs, corners, their_corners, differences)


def compare_vertices(call: Call, frame: Frame, draw: Draw, theirs: dict, corners: list[int], their_corners: list[int], size: float,
                     differences: Differences) -> bool:
    """Positions and normals of the corners in eye space. False where triangles are exchanged because they are as far."""
    eye_from_object = frame.eye_from_world @ draw.vertices.world_from_object
    their_matrix = matrix_of(theirs["eye_from_object"])
    points = draw.vertices.positions[corners]
    ours = points @ eye_from_object[:3, :3].T + eye_from_object[:3, 3]
    seen = rows(theirs["position"], 3)[their_corners] @ their_matrix[:3, :3].T + their_matrix[:3, 3]
    reach = max(size, float(np.abs(points).max()) * np.linalg.norm(eye_from_object[:3, :3])) if len(points) else size
    if draw.order is not None and np.abs(ours - seen).max() > BOUND * reach and nearly_sorted(frame, ours, seen, reach):
        differences.skipped += 1
        return False
    if not differences.near("positions", seen, ours, BOUND * reach):
        return False
    compare_normals(call, draw, theirs, corners, their_corners, eye_from_object, their_matrix, reach, differences)
    return True


def nearly_sorted(frame: Frame, ours: np.ndarray, seen: np.ndarray, reach: float) -> bool:
    """The same triangles, each as far as the one that should stand in its place."""
    parallel = frame.eye.half_height is not None

    def far(corners: np.ndarray) -> np.ndarray:
        middles = corners.reshape(-1, 3, 3).mean(axis=1)
        return -middles[:, 2] if parallel else np.linalg.norm(middles, axis=1)

    def by_place(corners: np.ndarray) -> np.ndarray:
        triangles = corners.reshape(-1, 9)
        return triangles[np.lexsort(np.round(triangles / (100 * BOUND * reach)).T)]

    return np.abs(far(ours) - far(seen)).max() <= 10 * BOUND * reach and np.abs(by_place(ours) - by_place(seen)).max() <= 10 * BOUND * reach


def made_normals(draw: Draw, corners: list[int], crease: float | None, reach: float) -> tuple[np.ndarray, np.ndarray]:
    """Where the file has none: at right angles to each triangle, counter-clockwise in the primitive's own space; or, with a crease
    angle, the sum of the triangles that meet at the point and lean no more than that, by their areas."""
    triangles = draw.vertices.positions[corners].reshape(-1, 3, 3)
    first, second = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    areas = np.cross(first, second)
    length = np.linalg.norm(areas, axis=1)
    sizes = np.maximum(np.linalg.norm(first, axis=1) * np.linalg.norm(second, axis=1), 1e-9)
    quality = np.repeat(np.minimum(length / sizes, sizes**0.5 / reach), 3)
    units = areas / np.maximum(length, 1e-300)[:, None]
    if crease is None:
        return np.repeat(units, 3, axis=0), quality
    normals, kept = np.zeros((len(corners), 3)), np.zeros(len(corners))
    lean = np.degrees(np.arccos(np.clip(units @ units.T, -1, 1)))
    points = [tuple(point) for point in draw.vertices.positions[corners]]
    for corner, point in enumerate(points):
        around = [other // 3 for other in range(len(corners)) if points[other] == point]
        angles = lean[corner // 3, around]
        normals[corner] = areas[around][angles <= crease].sum(axis=0)
        # Angles near the crease's own, and sums of which little is left, are not told apart.
        clear = np.abs(angles - crease).min() > 0.1 and quality.reshape(-1, 3)[around].min() > 0.01
        size = np.linalg.norm(normals[corner])
        kept[corner] = clear * min(quality[corner], size / max(length[around].sum(), 1e-300))
        normals[corner] /= max(size, 1e-300)
    return normals, kept


def compare_normals(call: Call, draw: Draw, theirs: dict, corners: list[int], their_corners: list[int], matrix: np.ndarray,
                    their_matrix: np.ndarray, reach: float, differences: Differences) -> None:
    if "normal" not in theirs:
        differences.expect(draw.vertices.normals is None, "normals are missing")
        return
    if draw.vertices.normals is None:
        normals, quality = made_normals(draw, corners, call.crease, reach)
    else:
        normals, quality = draw.vertices.normals[corners], draw.vertices.quality[corners]
    ours, kept = carried(np.broadcast_to(matrix[:3, :3], (len(normals), 3, 3)), normals)
    seen, _ = carried(np.broadcast_to(their_matrix[:3, :3], (len(normals), 3, 3)), rows(theirs["normal"], 3)[their_corners])
    if not theirs["normalize"]:
        differences.near("lengths of normals", np.linalg.norm(seen, axis=1), np.ones(len(seen)), 3e-3)
    quality = quality * kept
    good = quality > 1e-3
    differences.skipped += int((~good).sum())
    ours = ours / np.maximum(np.linalg.norm(ours, axis=1, keepdims=True), 1e-300)
    seen = seen / np.maximum(np.linalg.norm(seen, axis=1, keepdims=True), 1e-300)
    # Normals in whole numbers are taken for units where they are so to a thousandth.
    differences.near("normals", seen[good], ours[good], (np.full(good.sum(), 1e-3) + 1e-5 / quality[good])[:, None])


def compare_arrays(draw: Draw, theirs: dict, corners: list[int], their_corners: list[int], differences: Differences) -> None:
    attributes = draw.source["attributes"]
    if "COLOR_0" in attributes:
        colors = draw.values[attributes["COLOR_0"]][corners]
        colors = np.hstack([colors, np.ones((len(colors), 4 - colors.shape[1]))]) * draw.surface.color
        columns = len(theirs["color"]) // theirs["vertex_count"]
        seen = rows(theirs["color"], columns)[their_corners]
        if columns == 3:
            differences.expect(draw.material_source.get("alphaMode", "OPAQUE") == "OPAQUE", "colours without alpha")
        differences.near("colors", seen, colors[:, :columns], 1e-4)
    else:
        differences.expect("color" not in theirs, "colours from nowhere")
        if not draw.surface.lit:
            differences.near("constant color", theirs["constant_color"], draw.surface.color)
    for i, (unit, other) in enumerate(zip(draw.surface.units, theirs["units"], strict=False)):
        if unit.set is None:
            continue
        coordinates = draw.values[attributes[f"TEXCOORD_{unit.set}"]][corners]
        ours = coordinates @ unit.matrix[:2, :2].T + unit.matrix[:2, 2]
        matrix = matrix_of(other["matrix"])
        seen = rows(other["texcoord"], 2)[their_corners] @ matrix[:2, :2].T + matrix[:2, 3]
        differences.near(f"coordinates of unit {i}", seen, ours, 1e-4)


def compare_state(call: Call, frame: Frame, draw: Draw, theirs: dict, differences: Differences) -> None:
    mode = draw.material_source.get("alphaMode", "OPAQUE")
    both = draw.material_source.get("doubleSided", False) or call.wireframe
    cull = CULL[call.cull or ("none" if both else "back")]
    expected = {"shade_model": SHADINGS[frame.shading], "cull_face": cull, "front_face": int(draw.mirrored),
                "two_sided": int(cull != CULL["back"]), "lit": int(draw.surface.lit), "blend": int(mode == "BLEND"),
                "sorted": int(mode == "BLEND" and call.exact_order),
                "depth_write": int(mode != "BLEND"), "alpha_test": int(mode == "MASK"),
                "local_viewer": int(frame.eye.half_height is None), "fog": int(frame.fog_color is not None)}
    for name, value in expected.items():
        differences.expect(theirs[name] == value, f"{name} is {theirs[name]}, not {value}")
    if mode == "MASK":
        differences.near("alpha cut-off", theirs["alpha_reference"], draw.material_source.get("alphaCutoff", 0.5))
    if frame.fog_color is not None:
        differences.near("fog's colour", theirs["fog_color"][:3], frame.fog_color, 1e-4)
    compare_projection(frame, matrix_of(theirs["clip_from_eye"]), differences)


def compare_surface(call: Call, draw: Draw, theirs: dict, differences: Differences) -> None:
    surface = draw.surface
    differences.expect(len(theirs["units"]) == len(surface.units), f"{len(theirs['units'])} units, not {len(surface.units)}")
    for i, (unit, other) in enumerate(zip(surface.units, theirs["units"], strict=False)):
        compare_unit(f"unit {i}", call, unit, other, differences)
    if not surface.lit:
        return
    has_colors = "COLOR_0" in draw.source["attributes"]
    tracked = 0 if not has_colors else 2 if surface.own_ambient else 3
    differences.expect(theirs["color_material"] == tracked, f"color material {theirs['color_material']}, not {tracked}")
    for name in ("ambient", "diffuse", "specular", "emission"):
        ours = getattr(surface, name)
        differences.near(name, theirs[name][:len(ours)], ours, 1e-4)
    differences.near("shininess", theirs["shininess"], surface.shininess, 1e-4)


def compare_unit(what: str, call: Call, unit: Unit, theirs: dict, differences: Differences) -> None:
    differences.expect(theirs["env_mode"] == unit.mode, f"{what}: mode {theirs['env_mode']}, not {unit.mode}")
    differences.expect(bool(theirs["generated"]) == unit.reflects, f"{what}: generated coordinates")
    if unit.color is not None:
        differences.near(f"{what}: colour", theirs["env_color"][:3], unit.color, 1e-4)
    if unit.sampler is not None:
        smaller = call.min_filter or unit.sampler.get("minFilter", 9987)
        expected = (FILTERS[smaller], FILTERS[unit.sampler.get("magFilter", 9729)])
        differences.expect((theirs["min_filter"], theirs["mag_filter"]) == expected, f"{what}: filters")
        wraps = [WRAPS[unit.sampler.get(name, 10497)] for name in ("wrapS", "wrapT")]
        differences.expect(theirs["wraps"] == wraps, f"{what}: wraps {theirs['wraps']}, not {wraps}")
        differences.near(f"{what}: first texel", theirs["texel"][:3], unit.texel, 1.0 / 255)
