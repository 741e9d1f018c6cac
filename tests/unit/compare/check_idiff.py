"""`barrido diff` says what OpenImageIO's idiff says: the same verdict and the same figures, on pairs where both mean the
same. They do not where idiff 2.4 takes a missing channel for 0 (Barrido: alpha is opaque, grey is grey), multiplies colours
of PNG by alpha (Barrido compares what is stored), or has no pixel over -fail and forgets -warn and -hardfail.

usage: check_idiff.py BARRIDO
"""

import math
import pathlib
import re
import subprocess
import sys
import tempfile

import checks
import png

WIDTH, HEIGHT = 37, 23


def noise(x: int, y: int, c: int) -> int:
    return ((x * 2654435761 + y * 40503 + c * 977) * 2246822519 & 0xFFFFFFFF) >> 24


def convert(folder: pathlib.Path, *words: str) -> None:
    subprocess.run(["oiiotool", *words], cwd=folder, check=True)


def make_pictures(folder: pathlib.Path) -> None:
    # One value differs most, so that there is no tie for rounding to decide.
    def nudged(x, y, c, worst=1):
        if (x, y, c) == (30, 20, worst):
            return noise(x, y, c) ^ 128
        return min(255, noise(x, y, c) + (9 if (x + y * 3) % 11 == 0 else 0))

    def deep(x, y, c):
        return noise(x, y, c) * 255 + (700 if (x, y, c) == (30, 20, 2) else (x + y) % 3)

    png.write(folder / "a.png", WIDTH, HEIGHT, 3, noise)
    png.write(folder / "b.png", WIDTH, HEIGHT, 3, nudged)
    png.write(folder / "one.png", WIDTH, HEIGHT, 3, lambda x, y, c: noise(x, y, c) ^ ((x, y, c) == (3, 2, 2)))
    png.write(folder / "grey_a.png", WIDTH, HEIGHT, 1, noise)
    png.write(folder / "grey_b.png", WIDTH, HEIGHT, 1, lambda x, y, c: nudged(x, y, c, 0))
    png.write(folder / "deep_a.png", WIDTH, HEIGHT, 3, lambda x, y, c: noise(x, y, c) * 255, bits=16)
    png.write(folder / "deep_b.png", WIDTH, HEIGHT, 3, deep, bits=16)
    png.write(folder / "opaque_a.png", WIDTH, HEIGHT, 4, lambda x, y, c: 255 if c == 3 else noise(x, y, c))
    png.write(folder / "opaque_b.png", WIDTH, HEIGHT, 4, lambda x, y, c: 255 if c == 3 else nudged(x, y, c))
    png.write(folder / "small.png", WIDTH - 10, HEIGHT - 4, 3, noise)
    for name in ("a", "b", "opaque_a", "opaque_b"):
        convert(folder, f"{name}.png", "--mulc", "3.5", "-d", "float", "-o", f"{name}.exr")
    convert(folder, "deep_a.png", "-d", "uint16", "-o", "deep_a.tif")


CASES = [
    ["a.png", "a.png"],
    ["a.png", "b.png"],
    ["a.png", "one.png"],
    ["grey_a.png", "grey_b.png"],
    ["deep_a.png", "deep_b.png"],
    ["deep_a.tif", "deep_b.png"],
    ["opaque_a.png", "opaque_b.png"],
    ["a.png", "small.png"],
    ["small.png", "a.png"],
    ["a.exr", "b.exr"],
    ["opaque_a.exr", "opaque_b.exr"],
    ["-fail", "0.1", "-warn", "0.1", "a.png", "b.png"],
    ["-failpercent", "20", "a.png", "b.png"],
    ["-failpercent", "20", "-warnpercent", "20", "a.png", "b.png"],
    ["-failpercent", "5", "a.png", "b.png"],
    ["-failpercent", "20", "-hardfail", "0.01", "a.png", "b.png"],
    ["-failpercent", "20", "-hardfail", "0.1", "a.png", "b.png"],
    ["-failpercent", "20", "-warnpercent", "20", "-hardwarn", "0.01", "a.png", "b.png"],
    ["-allowfailures", "100", "-warnpercent", "50", "a.png", "b.png"],
    ["-allowfailures", "10", "a.png", "b.png"],
]
FIGURES = {
    "mean": r"Mean error = (\S+)",
    "rms": r"RMS error = (\S+)",
    "max": r"Max error  = (\S+)",
    "psnr_db": r"Peak SNR = (\S+)",
}
VERDICTS = {"PASS": "same", "WARNING": "warning", "FAILURE": "different"}


def idiff(folder: pathlib.Path, *words: str) -> subprocess.CompletedProcess:
    return subprocess.run(["idiff", *words], cwd=folder, capture_output=True, text=True, check=False)


def compare(case: list[str], barrido: checks.Barrido, check: checks.Checks) -> None:
    theirs = idiff(barrido.folder, "-v", *case).stdout
    ours = barrido.pairs("--no-flip", *case)[0]
    name = " ".join(case)
    check.equal(ours["outcome"], VERDICTS[theirs.split()[-1]], name)
    for key, pattern in FIGURES.items():
        expected = float(re.search(pattern, theirs)[1])
        found = ours["figures"][key]
        if found is None:
            check.expect(math.isinf(expected), f"{name}: {key}: none, but {expected} in idiff")
        else:
            near = math.isclose(found, expected, rel_tol=2e-5, abs_tol=1e-9)
            check.expect(near, f"{name}: {key}: {found}, but {expected} in idiff")
    counts = [int(count) for count in re.findall(r"(\d+) pixels", theirs)]
    check.equal([ours["figures"]["pixels_over_warn"], ours["figures"]["pixels_over_fail"]], counts, f"{name}: pixels")
    place = re.search(r"@ \((\d+), (\d+), (\w)\)", theirs)
    if place:
        worst = ours["figures"]["worst"]
        channel = "Y" if "grey" in name else worst["channel"]
        check.equal((str(worst["x"]), str(worst["y"]), channel), place.groups(), f"{name}: place")


def main() -> int:
    checks.need("idiff", "openimageio-tools")
    check = checks.Checks()
    with tempfile.TemporaryDirectory() as folder:
        make_pictures(pathlib.Path(folder))
        barrido = checks.Barrido(sys.argv[1], pathlib.Path(folder))
        for case in CASES:
            compare(case, barrido, check)
        # What the difference picture holds: idiff's own -o, read back by idiff.
        words = ["-abs", "-scale", "3", "a.png", "b.png"]
        idiff(barrido.folder, "-o", "theirs.png", *words)
        check.equal(barrido.diff("-o", "ours.png", *words).returncode, 1, "-o")
        same = idiff(barrido.folder, "-fail", "0.004", "theirs.png", "ours.png")
        check.expect(same.returncode == 0, "-o: another picture than idiff's: " + same.stdout)
    return check.end()


if __name__ == "__main__":
    sys.exit(main())
