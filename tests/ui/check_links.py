"""Checks that the program `barrido` has no window system, no OpenGL and none of the modules in it: what is mapped while
it draws a picture that needs none.

usage: check_links.py BARRIDO
"""

import pathlib
import re
import subprocess
import sys

UNWANTED = re.compile(r"lib(GL|GLX|GLdispatch|EGL|OpenGL|OSMesa|X11|xcb|glfw|wayland-\w+|imgui|OpenImageIO|draco|meshoptimizer|webp|webpmux|gif)[.\-]|barrido_\w+\.so")
MODEL = pathlib.Path(__file__).resolve().parents[2] / "models" / "teapot.glb"


def main() -> int:
    barrido = sys.argv[1]
    # LD_DEBUG tells every library that is loaded, also those opened on demand.
    result = subprocess.run([barrido, "render", MODEL, "--hash", "--resolution", "64,64"], capture_output=True,
                            text=True, env={"LD_DEBUG": "files"}, check=False)
    libraries = set(re.findall(r"file=(\S+) \[\d+\];  needed by|calling init: (\S+)", result.stderr))
    names = {name for pair in libraries for name in pair if name}
    if result.returncode != 0 or not names:
        print(f"barrido ended with {result.returncode} and {len(names)} libraries were seen")
        return 1
    unwanted = sorted(name for name in names if UNWANTED.search(name))
    for name in unwanted:
        print(f"barrido loads {name}")
    return 1 if unwanted else 0


if __name__ == "__main__":
    sys.exit(main())
