"""`barrido info` and `barrido render` say the same of a file: drawn or refused, with the same reason and warnings.

usage: check_agreement.py BARRIDO FOLDER...      status 77: there is none of the folders
"""

import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

MODELS = (".gltf", ".glb")
# What only drawing can tell.
OF_DRAWING = ("the picture is empty", "reflecting objects", "lights: the first", "slices")


def run(program: str, words: list[str], folder: str) -> tuple[int, list[str]]:
    result = subprocess.run([program, *words], capture_output=True, text=True, errors="replace", check=False, cwd=folder)
    lines = [line for line in result.stderr.splitlines() if not any(words in line for words in OF_DRAWING)]
    return result.returncode, sorted(lines)


def disagreement(program: str, file: pathlib.Path) -> str:
    with tempfile.TemporaryDirectory() as folder:
        info = run(program, ["info", str(file)], folder)
        render = run(program, ["render", str(file), "-o", "x.png", "--resolution", "16,16"], folder)
    if info == render:
        return ""
    return f"{file}:\n  info   {info}\n  render {render}"


def main() -> int:
    program = os.path.abspath(sys.argv[1])
    folders = [folder for folder in map(pathlib.Path, sys.argv[2:]) if folder.is_dir()]
    files = sorted(f.resolve() for folder in folders for f in folder.rglob("*") if f.suffix in MODELS and f.is_file())
    if not files:
        print("none of the folders is here; skipped")
        return 77
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [line for line in pool.map(lambda file: disagreement(program, file), files) if line]
    print(f"{len(files)} files, {len(found)} disagreements")
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
