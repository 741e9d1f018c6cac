"""Checks what the shape of the sources promises: the direction of includes, the length of files, nothing left open.

usage: check_style.py PROJECT_FOLDER

Prints one line a finding and exits with status 1 when there is one.
"""

import pathlib
import re
import sys

SOURCE_SUFFIXES = {".cpp", ".h", ".cc", ".hpp"}
CODE_FOLDERS = ("raster", "pipeline", "viewer", "models", "tests", "examples")
MAX_LINES = 400

# Rooms from the lowest to the highest: a file may include only its own room and those before it.
LAYERS = [
    "raster/base",
    "raster/textures",
    "raster/fragments",
    "raster/tiles",
    "raster/kernels",
    "raster/reference",
    "raster",
    "pipeline",
    "pipeline/kernels",
    "pipeline/files",
    "pipeline/pictures",
    "pipeline/scene",
    "pipeline/gltf",
    "pipeline/validate",
    "pipeline/inspect",
    "viewer",
]
# Headers that only one folder may see.
PRIVATE_HEADERS = {
    r"tiny_gltf\.h|tinygltf": ["pipeline/gltf"],
    r"OpenImageIO/": ["pipeline/pictures"],
    r"draco/|meshoptimizer\.h": ["pipeline/gltf", "tests"],
    r"webp/": ["pipeline/pictures", "tests"],
    r"gif_lib.h": ["pipeline/pictures/gif_module", "tests"],
    r"spng\.h|jpeglib\.h|turbojpeg\.h|png\.h": ["pipeline/pictures", "models/tool", "tests"],
    r"GLFW/|imgui": ["viewer/barrido-view", "tests"],
    r"GL/": ["viewer/barrido-view", "viewer/osmesa", "tests"],
    r"CLI/": ["viewer", "tests/bench"],
}
OPEN_WORK = re.compile(r"\b(" + "|".join(["TO" + "DO", "FIX" + "ME", "XX" + "X", "HA" + "CK"]) + r")\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def layer_of(path: str) -> str | None:
    """The innermost layer that holds a path relative to the project; None outside all layers."""
    holding = [layer for layer in LAYERS if path.startswith(layer + "/")]
    return max(holding, key=len) if holding else None


def include_findings(path: str, text: str) -> list[str]:
    findings = []
    layer = layer_of(path)
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        header = match[1]
        included = layer_of(header)
        if layer and included and LAYERS.index(included) > LAYERS.index(layer):
            findings.append(f"{path}:{number}: {layer} must not include {included} ({header})")
        if layer and header.split("/")[0] in {"tests", "models", "examples"}:
            findings.append(f"{path}:{number}: {layer} must not include {header}")
        for pattern, folders in PRIVATE_HEADERS.items():
            if re.match(pattern, header) and not any(path.startswith(folder + "/") for folder in folders):
                findings.append(f"{path}:{number}: only {', '.join(folders)} may include {header}")
    return findings


def file_findings(path: str, text: str) -> list[str]:
    findings = []
    lines = text.splitlines()
    if len(lines) > MAX_LINES:
        findings.append(f"{path}: {len(lines)} lines, more than {MAX_LINES}")
    findings += [f"{path}:{n}: left open: {line.strip()}" for n, line in enumerate(lines, 1) if OPEN_WORK.search(line)]
    return findings


def check(root: pathlib.Path) -> list[str]:
    findings = []
    for folder in CODE_FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in SOURCE_SUFFIXES and file.is_file():
                path = file.relative_to(root).as_posix()
                text = file.read_text(encoding="utf-8")
                findings += file_findings(path, text) + include_findings(path, text)
    return findings


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    if not (root / "raster").is_dir():
        print(f"{root}: no raster/ below it; is this the project's folder?")
        return 2
    findings = check(root)
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
