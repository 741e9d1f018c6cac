"""Small files that were once drawn wrong, each for a kind of fault: every one gives the right value now.

usage: check_reports.py BARRIDO REPORTS_FOLDER      status 77: there is no such folder
"""

import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile

from png import Picture


class Check:
    def __init__(self, program: str, reports: pathlib.Path, folder: pathlib.Path):
        self.program, self.reports, self.folder, self.failures = program, reports, folder, []

    def expect(self, holds: bool, message: str) -> None:
        if not holds:
            self.failures.append(message)

    def run(self, *words) -> subprocess.CompletedProcess:
        return subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, check=False, cwd=self.folder)

    def draw(self, file: str, *options, warning: str = "") -> Picture | None:
        """The picture of a file that is drawn with status 0, and with a warning that holds these words."""
        path = self.reports / file
        result = self.run("render", path, "-o", "x.png", "--resolution", "100,100", *options)
        self.expect(result.returncode == 0, f"{file}: exit status {result.returncode}: {result.stderr}")
        self.expect(warning in result.stderr, f"{file}: no '{warning}' in '{result.stderr}'")
        if not warning:
            self.expect(result.stderr == "", f"{file}: unexpected: {result.stderr}")
        return Picture(self.folder / "x.png") if result.returncode == 0 else None

    def middle(self, file: str, value: tuple[int, ...], *options, warning: str = "") -> None:
        picture = self.draw(file, *options, warning=warning)
        if picture:
            self.expect(picture.middle == value, f"{file}: the middle is {picture.middle}, not {value}")

    def same(self, file: str, other: str, *options) -> None:
        a, b = self.draw(file, *options), self.draw(other, *options)
        if a and b:
            self.expect(a.differing(b) == 0, f"{file}: {a.differing(b)} pixels are not those of {other}")


def is_red(pixel) -> bool:
    return pixel[0] > 200 and pixel[1] < 60 and pixel[2] < 60


def check_alpha(check: Check) -> None:
    clear = ("--background", "0,0,0,0")
    for management in ("srgb", "none"):
        more = (*clear, "--color-management", management)
        check.middle("blend-over-transparent/white.glb", (255, 255, 255, 128), *more)
        check.middle("mask-alpha/mask.glb", (255, 0, 0, 255), *more)
    check.middle("blend-sorting/interleaved.glb", (152, 7, 207, 255))


def check_places(check: Check) -> None:
    check.same("mirrored-skin/mirrored.glb", "mirrored-skin/unmirrored.glb")
    check.same("georeferenced/utm.gltf", "georeferenced/origin.gltf")
    check.same("far-vanishes/far.glb", "far-vanishes/far_ok.glb")
    check.same("framing-unused-vertices/shared.glb", "framing-unused-vertices/alone.glb")
    for file in ("single-point/point.glb", "single-point/origin.glb"):
        picture = check.draw(file)
        if picture:
            middles = [picture[x, y] for x in (49, 50) for y in (49, 50)]
            check.expect(any(map(is_red, middles)), f"{file}: the middle is {middles}")
            check.expect(picture.count(is_red) == 1, f"{file}: {picture.count(is_red)} red pixels")


def check_pictures(check: Check) -> None:
    check.middle("missing-texture/model.gltf", (255, 0, 0, 255), warning="missing.png")
    check.draw("two-4k-textures/model.glb")
    direction = ("--background", "environment", "--camera-position", "0,0,0", "--camera-focal-point", "0,1,0.01")
    for name in ("minus_y", "plus_y"):
        environment = check.reports / f"hdr-plus-y/{name}.hdr"
        picture = check.draw("hdr-plus-y/dummy.glb", "--environment", environment, *direction)
        if picture:
            red, _, blue, _ = picture.middle
            check.expect(blue > 200 > red, f"{name}.hdr: the sky is {picture.middle}")


def check_files(check: Check) -> None:
    check.draw("data-uri/upper.gltf")
    check.draw("unused-broken-mesh/model.glb", warning="nothing")
    check.draw("silently-ignored/normal.glb")
    morphed = check.draw("silently-ignored/morph_color.glb")
    if morphed:
        check.expect(morphed.middle != (0, 0, 0, 255), "morph_color.glb: black")
    spot = check.reports / "spot-without-spot/model.glb"
    result = check.run("render", spot, "-o", "x.png")
    line = f"barrido: {spot}: extensions.KHR_lights_punctual.lights[0].spot: is missing\n"
    check.expect((result.returncode, result.stderr.replace("error: ", "")) == (2, line), f"spot: {result.stderr}")


def check_diff(check: Check) -> None:
    pair = [check.reports / "diff-nan-figures" / name for name in ("f.exr", "n.exr")]
    result = check.run("diff", *pair, "--json", "report.json")
    check.expect(result.returncode == 1, f"diff over NaN: exit status {result.returncode}")
    for words in ("Mean error = nan", "RMS error  = nan", "Peak SNR   = nan"):
        check.expect(words in result.stdout, f"diff over NaN: no '{words}' in {result.stdout}")
    check.expect("FLIP mean  = 0," not in result.stdout, f"diff over NaN: {result.stdout}")
    figures = json.loads((check.folder / "report.json").read_text(encoding="utf-8"))["pairs"][0]["figures"]
    check.expect(figures["mean"] is None and figures["psnr_db"] is None, f"diff over NaN: {figures}")
    check.expect(figures["incomparable_values"] > 0, f"diff over NaN: {figures}")


def check_protected(check: Check) -> None:
    file = check.folder / "protected.png"
    file.write_bytes(b"kept")
    file.chmod(0o444)
    result = check.run("render", check.reports / "mask-alpha/mask.glb", "-o", file, "--resolution", "10,10")
    mode = stat.S_IMODE(file.stat().st_mode)
    check.expect(mode == 0o444, f"a write-protected file has the mode {mode:o} now")
    if os.geteuid() != 0:
        check.expect(result.returncode == 2 and "Permission denied" in result.stderr, f"protected: {result.stderr}")
        check.expect(file.read_bytes() == b"kept", "a write-protected file was replaced")


def main() -> int:
    reports = pathlib.Path(sys.argv[2]).resolve()
    if not reports.is_dir():
        print(f"{reports}: no such folder; skipped")
        return 77
    with tempfile.TemporaryDirectory() as name:
        check = Check(os.path.abspath(sys.argv[1]), reports, pathlib.Path(name))
        for part in (check_alpha, check_places, check_pictures, check_files, check_diff, check_protected):
            part(check)
    for failure in check.failures:
        print(failure)
    return 1 if check.failures else 0


if __name__ == "__main__":
    sys.exit(main())
