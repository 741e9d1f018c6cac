"""What is large in earnest is drawn without a word; what exceeds --max-memory or --max-seconds is refused by the program itself.

usage: check_limits.py PROGRAM [--sanitized]
"""

import os
import pathlib
import random
import struct
import sys
import tempfile
from array import array

import pictures
from calls import call
from models import FLOAT, UINT, Model, textured, triangle


def grid(cells: int, normals: bool) -> Model:
    """2 cells² triangles over a square."""
    side = cells + 1
    positions = array("f")
    for y in range(side):
        for x in range(side):
            positions.extend((x / cells, y / cells, (x * 7 + y * 3) % 5 / 50))
    indices = array("I")
    for y in range(cells):
        for x in range(cells):
            a = y * side + x
            indices.extend((a, a + 1, a + side, a + 1, a + side + 1, a + side))
    model = Model()
    for numbers, component, kind, width in [(positions, FLOAT, "VEC3", 3), (indices, UINT, "SCALAR", 1)]:
        model.append("accessors", {"bufferView": model.view(numbers.tobytes()), "componentType": component, "type": kind, "count": len(numbers) // width})
    attributes = {"POSITION": 0}
    if normals:
        view = model.view(struct.pack("<3f", 0, 0, 1) * side * side)
        attributes["NORMAL"] = model.append("accessors", {"bufferView": view, "componentType": FLOAT, "type": "VEC3", "count": side * side})
    model.document.update({"meshes": [{"primitives": [{"attributes": attributes, "indices": 1}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]})
    return model


def assembly(parts: int) -> Model:
    """As programs for construction write them: a node, a mesh, a primitive and accessors of its own for each part."""
    model = triangle()
    positions = model.document["accessors"][0]
    model.document["accessors"] = [dict(positions) for _ in range(parts)]
    model.document["meshes"] = [{"name": f"part {i}", "primitives": [{"attributes": {"POSITION": i}}]} for i in range(parts)]
    model.document["nodes"] = [{"name": f"part {i}", "mesh": i, "translation": [i % 100, i // 100, 0]} for i in range(parts)]
    model.document["nodes"].append({"name": "all", "children": list(range(parts))})
    model.document["scenes"] = [{"nodes": [parts]}]
    return model


def photographs(count: int) -> Model:
    """Textures of 4096² pixels that are packed as photographs are, a megabyte each."""
    model = textured(pictures.png(2, 2))
    noise = random.Random(1)
    raw = b"".join(b"\0" + (noise.randbytes(4096) if y % 16 == 0 else bytes(4096)) for y in range(4096))
    picture = pictures.png(4096, 4096, 8, 0, raw=raw)
    model.document["images"] = [{"bufferView": model.view(picture), "mimeType": "image/png"} for _ in range(count)]
    model.document["textures"] = [{"source": i} for i in range(count)]
    model.document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(count)]
    part = model.document["meshes"][0]["primitives"][0]
    model.document["meshes"][0]["primitives"] = [{**part, "material": i} for i in range(count)]
    return model


class Checks:
    def __init__(self, program: str, sanitized: bool) -> None:
        self.program, self.sanitized = program, sanitized
        self.count = 0
        self.failures: list[str] = []

    def run(self, name: str, model: Model, options: list[str], says: str = "", most_mb: int = 0) -> None:
        """`says`: in the line of an error that is due; empty: none is."""
        self.count += 1
        if self.sanitized and "--max-seconds" not in options:
            options = [*options, "--max-seconds", "100"]  # Ten times slower there.
        with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as folder_name:
            folder = pathlib.Path(folder_name)
            (folder / "model.glb").write_bytes(model.glb())
            size = (folder / "model.glb").stat().st_size
            answer = call(self.program, ["render", "model.glb", "-o", "out.png", *options], folder, True)
            left = {path.name for path in folder.iterdir()} - {"model.glb"}
        print(f"{name} ({size >> 10} KB): status {answer.status}, {answer.memory_kb >> 10} MB {answer.lines[:1]}")
        lines = [line for line in answer.lines if not line.startswith("barrido: warning: ")]
        fine = answer.status == 0 and not lines and left == {"out.png"}
        if says:
            fine = answer.status == 2 and len(answer.lines) == 1 and says in answer.lines[0] and not left
        if most_mb and not self.sanitized:
            fine = fine and answer.memory_kb <= most_mb << 10
        if not fine:
            self.failures.append(f"{name}: status {answer.status}, {answer.memory_kb >> 10} MB, left {sorted(left)}: {answer.lines[:3]}")


def large_in_earnest(checks: Checks) -> None:
    small = ["--resolution", "320,240"]
    checks.run("a million triangles", grid(708, True), small)
    checks.run("half a million triangles without normals", grid(500, False), small)
    checks.run("half a million triangles without normals, creases", grid(500, False), [*small, "--crease-angle", "30"])
    checks.run("a frame of 4096²", triangle(), ["--resolution", "4096,4096"])
    checks.run("a sheet of frames", triangle(), ["--sheet", "--shading", "all", "--resolution", "2000,1500"])
    checks.run("100 frames", triangle(), ["--resolution", "640,480", "--turntable", "100", "--sheet"])
    checks.run("20,000 parts", assembly(20_000), small)
    checks.run("three photographs", photographs(3), small)


def more_than_allowed(checks: Checks) -> None:
    small = ["--resolution", "320,240"]
    checks.run("a million triangles, 16M", grid(708, True), [*small, "--max-memory", "16M"], "--max-memory", 120)
    checks.run("a photograph, 80M", photographs(1), [*small, "--max-memory", "80M"], "--max-memory", 120)
    checks.run("all in time and memory", triangle(), [*small, "--max-memory", "64M", "--max-seconds", "60"])
    checks.run("a frame of 16384², 0.2 s", triangle(), ["--resolution", "16384,16384", "--max-seconds", "0.2"], "--max-seconds")
    bomb = textured(pictures.png(8192, 8192, 1, 0))
    checks.run("a picture of zeros", bomb, small, "--max-memory", 128)
    if not checks.sanitized:  # What no account is kept of is limited by the system, which sanitizers do not bear.
        checks.run("a million triangles, 64M", grid(708, True), [*small, "--max-memory", "64M"], "--max-memory", 120)
        checks.run("a frame of 8192², 100M", triangle(), ["--resolution", "8192,8192", "--max-memory", "100M"], "--max-memory", 120)
        checks.run("a picture of zeros, allowed", bomb, [*small, "--max-memory", "2G"])
    many = triangle()
    many.document["nodes"] = [{"mesh": 0}] * 250_000
    many.document["scenes"] = [{"nodes": list(range(250_000))}]
    checks.run("250,000 nodes", many, small, "--max-memory", 512)


def main() -> int:
    checks = Checks(os.path.abspath(sys.argv[1]), "--sanitized" in sys.argv)
    large_in_earnest(checks)
    more_than_allowed(checks)
    print("\n".join(checks.failures))
    print(f"{checks.count} checks, {len(checks.failures)} failed")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
