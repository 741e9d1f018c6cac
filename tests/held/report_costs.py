"""`--stats` of scenes whose costs can be counted by hand: rectangles of whole pixels under parallel rays, none over another."""

import json
import random
import re

import numpy as np

from glb import Glb

SIDE, CELL = 48, 12
LIGHTS = ["directional:dir=0,0,-1", "directional:dir=1,0,-1", "point:pos=24,24,4"]


class Rectangles:
    """In some cells of the frame, and beside it. Widths are even and heights odd, so that no pixel's centre lies on a diagonal."""

    def __init__(self, seed: int) -> None:
        rng = random.Random(seed)
        self.glb = Glb(rng)
        self.front: list[tuple[int, int]] = []  # Sizes of those that are seen
        self.count = 0
        self.glb.add("cameras", {"type": "orthographic", "orthographic": {"xmag": SIDE / 2, "ymag": SIDE / 2, "znear": 0, "zfar": 10}})
        self.glb.add("materials", {"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}})
        for x in (*range(0, SIDE, CELL), SIDE + CELL):
            for y in range(0, SIDE, CELL):
                if rng.random() < 0.5 or (x, y) == (0, 0):
                    self._add(x, y, 2 * rng.randint(1, 5), 2 * rng.randint(0, 4) + 1, rng.random() < 0.7 or (x, y) == (0, 0))
        self.glb.add("nodes", {"camera": 0, "translation": [SIDE / 2, SIDE / 2, 5]})
        self.glb.add("scenes", {"nodes": list(range(self.count + 1))})

    def _add(self, x: int, y: int, width: int, height: int, front: bool) -> None:
        corners = np.array([[x, y, 0], [x + width, y, 0], [x + width, y + height, 0], [x, y + height, 0]])
        indices = np.array([0, 1, 2, 0, 2, 3] if front else [0, 2, 1, 0, 3, 2])
        attributes = {"POSITION": self.glb.accessor(corners), "NORMAL": self.glb.accessor(np.tile([0, 0, 1], (4, 1)))}
        primitive = {"attributes": attributes, "indices": self.glb.accessor(indices[:, None], np.uint16, vertex=False), "material": 0}
        self.glb.add("nodes", {"mesh": self.glb.add("meshes", {"primitives": [primitive]})})
        self.count += 1
        if front and x < SIDE:
            self.front.append((width, height))

    def expected(self, shading: str, lights: int) -> dict:
        """Counts of a frame (course_counts, and the stages that lead to them)."""
        vertices, fragments, polygons = 4 * self.count, sum(w * h for w, h in self.front), 2 * len(self.front)
        per_vertex = {"flat": polygons, "gouraud": vertices, "cheap-phong": vertices, "phong": 0}[shading] * lights
        per_fragment = fragments * lights if shading in ("cheap-phong", "phong") else 0
        return {"draws": self.count, "vertices": vertices, "primitives_in": 2 * self.count,
                "primitives_culled": 2 * self.count - polygons, "primitives_clipped": 0, "illuminations_vertex": per_vertex,
                "illuminations_fragment": per_fragment, "fragments_covered": fragments, "fragments_shaded": fragments,
                "illuminations": per_vertex + per_fragment, "fragments": fragments, "polygons": polygons, "texel_fetches": 0,
                "scanlines": sum(scanlines(w, h) for w, h in self.front),
                "powers": per_fragment if shading == "cheap-phong" else per_vertex + per_fragment}


def scanlines(width: int, height: int) -> int:
    """Rows in which each of the two triangles of a rectangle has a pixel's centre."""
    rows = 0
    for y in range(height):
        below = [(x + 0.5) * height > (y + 0.5) * width for x in range(width)]
        rows += any(below) + (not all(below))
    return rows


def check_ratios(counts: dict, parts: list[tuple[str, int]], lines: list[str]) -> None:
    for name, part in parts:
        for quantity, value in counts[name].items():
            ours = counts[quantity] / part if part else None
            if (value is None) != (ours is None) or (ours is not None and abs(value - ours) > 1e-9 * max(1, ours)):
                lines.append(f"{name} {quantity} is {value}, not {ours}")


def check_frame(scene: Rectangles, frame: dict, lights: int, lines: list[str]) -> int:
    counts = frame["counts"]
    told = {**counts, **frame["stages"]}
    expected = scene.expected(frame["shading"], lights)
    lines += [f"{frame['shading']}: {name} is {told[name]}, not {value}" for name, value in expected.items() if told[name] != value]
    if counts["additions"] != counts["interpolations"] or counts["interpolations"] % counts["fragments"]:
        lines.append(f"{counts['interpolations']} interpolations for {counts['fragments']} fragments")
    check_ratios(counts, [("per_polygon", counts["polygons"]), ("per_scanline", counts["scanlines"])], lines)
    return len(expected)


def check_modes(report: dict, lines: list[str]) -> None:
    for mode, told in report["modes"].items():
        frames = [frame["counts"] for frame in report["frames"] if frame["shading"] == mode]
        for name in ("illuminations", "interpolations", "additions", "powers", "polygons", "scanlines", "fragments"):
            if told[name] != sum(frame[name] for frame in frames):
                lines.append(f"{mode}: sum of {name} is {told[name]}")
        if told["frames"] != len(frames):
            lines.append(f"{mode}: {told['frames']} frames")
        check_ratios(told, [("per_frame", len(frames)), ("per_polygon", told["polygons"]), ("per_scanline", told["scanlines"])], lines)


def check_text(text: str, report: dict, lines: list[str]) -> None:
    """The table of each mode, rounded; counts a frame to the nearest."""
    for mode, told in report["modes"].items():
        part = ("\n" + text).split(f"\n{mode}: ")[1].split("\n\n")[0]
        for name in ("illuminations", "interpolations", "additions", "powers", "fragments"):
            row = re.search(rf"^  {name} +(.*)$", part, re.MULTILINE).group(1)
            numbers = [re.sub(r"[^0-9.]", "", number) for number in re.split(r"  +", row)]
            ours = [f"{int(told[name] / told['frames'] + 0.5)}", f"{told[name] / told['polygons']:.2f}", f"{told[name] / told['scanlines']:.2f}"]
            if any(abs(float(a) - float(b)) > 0.0101 for a, b in zip(numbers, ours, strict=True)):
                lines.append(f"{mode}: {name} is told as {numbers}, not {ours}")


def check(program, lines: list[str]) -> int:
    count = 0
    for seed in range(1, 9):
        scene, lights = Rectangles(seed), seed % 4
        (program.folder / "r.glb").write_bytes(scene.glb.bytes())
        words = ["render", "r.glb", "--resolution", f"{SIDE},{SIDE}", "--shading", "all",
                 *(word for light in LIGHTS[:lights] for word in ("--light", light)), *([] if lights else ["--no-lights"])]
        report = json.loads(program(*words, "--stats=json")[1])
        for frame in report["frames"]:
            count += check_frame(scene, frame, lights, lines)
        check_modes(report, lines)
        words += ["--turntable", "3"]
        report = json.loads(program(*words, "--stats=json")[1])
        check_modes(report, lines)
        check_text(program(*words, "--stats")[1].decode(), report, lines)
    return count
