"""`barrido diff` on random pictures: counts, percentages, means, the worst pixel, and which limits make it fail."""

import json
import math
import random

import numpy as np

from glb import png_of

NAMES = ["grey", "grey and alpha", "RGB", "RGBA"]


class Pair:
    """Two pictures of bytes whose values differ in some pixels."""

    def __init__(self, rng: random.Random) -> None:
        height, width, channels = rng.randint(1, 13), rng.randint(1, 13), rng.randint(1, 4)
        draw = np.random.default_rng(rng.randrange(1 << 30))
        self.expected = draw.integers(0, 256, (height, width, channels), dtype=np.uint8)
        self.actual = self.expected.copy()
        touched = draw.random((height, width, channels)) < rng.choice([0.0, 0.05, 0.3, 1.0])
        change = draw.integers(-12, 13, self.expected.shape)
        self.actual[touched] = np.clip(self.expected.astype(int) + change, 0, 255).astype(np.uint8)[touched]
        self.differences = np.abs((self.expected / np.float32(255)).astype(np.float64) - (self.actual / np.float32(255)).astype(np.float64))

    def pixels_over(self, limit: float) -> int:
        return int((self.differences.max(axis=2) > limit).sum())

    @property
    def pixels(self) -> int:
        return self.expected.shape[0] * self.expected.shape[1]

    def figures(self, fail: float, warn: float) -> dict:
        rms = float(np.sqrt((self.differences**2).mean()))
        figures = {"mean": self.differences.mean(), "rms": rms, "psnr_db": None if rms == 0 else -20 * math.log10(rms),
                   "max": self.differences.max(), "pixels": self.pixels, "pixels_over_fail": self.pixels_over(fail),
                   "pixels_over_warn": self.pixels_over(warn)}
        if rms > 0:
            y, x, channel = np.unravel_index(np.argmax(self.differences), self.differences.shape)
            name = "A" if channel == 1 and self.differences.shape[2] == 2 else "RGBA"[channel]
            figures["worst"] = {"x": int(x), "y": int(y), "channel": name}
        return figures

    def outcome(self, limits: dict) -> str:
        """OpenImageIO's rules: more pixels than both the percentage and the number allow, or one too large a difference."""
        failing, warning = self.pixels_over(limits["fail"]), self.pixels_over(limits["warn"])
        most = self.differences.max()
        if failing > max(limits["failpercent"] / 100 * self.pixels, limits["allowfailures"]) or most > limits["hardfail"]:
            return "different"
        warned = warning > limits["warnpercent"] / 100 * self.pixels or most > limits["hardwarn"]
        return "warning" if warned else "same"


def random_limits(rng: random.Random, pair: Pair) -> dict:
    """Percentages often lie a hair's breadth on one side of what there is, and are seldom whole."""
    limits = {"fail": rng.choice([1e-6, (rng.randrange(12) + 0.5) / 255]), "warn": rng.choice([1e-6, (rng.randrange(12) + 0.5) / 255]),
              "failpercent": 0.0, "warnpercent": 0.0, "allowfailures": 0, "hardfail": math.inf, "hardwarn": math.inf}
    for name, limit in (("failpercent", "fail"), ("warnpercent", "warn")):
        share = 100 * pair.pixels_over(limits[limit]) / pair.pixels
        limits[name] = rng.choice([0.0, max(0.0, share - 0.01), min(100.0, share + 0.01), round(rng.uniform(0, 100), 2)])
    if rng.random() < 0.3:
        limits["allowfailures"] = max(0, pair.pixels_over(limits["fail"]) + rng.choice([-1, 0, 1]))
    for name in ("hardfail", "hardwarn"):
        if rng.random() < 0.3:
            limits[name] = (rng.randrange(13) + 0.5) / 255
    return limits


def near(ours, theirs) -> bool:
    if isinstance(ours, dict):
        return all(near(value, theirs[name]) for name, value in ours.items())
    if isinstance(ours, (int, str)) or ours is None:
        return ours == theirs
    return theirs is not None and abs(ours - theirs) <= 1e-6 * max(1, abs(ours))


def expect_text(pair: Pair, limits: dict, text: str, lines: list[str]) -> None:
    for name in ("warn", "fail"):
        count = pair.pixels_over(limits[name])
        kind = f" ({name})" if limits["warn"] != limits["fail"] else ""
        line = f"  {count} pixels ({100 * count / pair.pixels:.3g}%) over {limits[name]:.6g}{kind}"
        if line not in text.splitlines():
            lines.append(f"'{line}' is missing in: {text}")


def check(program, lines: list[str]) -> int:
    rng, count = random.Random(5), 0
    for number in range(60):
        pair = Pair(rng)
        for name, pixels in (("a.png", pair.expected), ("b.png", pair.actual)):
            (program.folder / name).write_bytes(png_of(pixels))
        limits = random_limits(rng, pair)
        words = [word for name, value in limits.items() if value != math.inf for word in (f"--{name}", repr(value))]
        if number % 3 == 0 and pair.outcome(limits) != "same":
            _, text, _ = program("diff", "a.png", "b.png", *words, "--no-flip")
            expect_text(pair, limits, text.decode(), lines)
        status, text, error = program("diff", "a.png", "b.png", *words, "--no-flip", "--quiet", "--json", "-")
        if status == 2:
            lines.append(f"{words}: {error!r}")
            continue
        report = json.loads(text)["pairs"][0]
        outcome, figures = pair.outcome(limits), pair.figures(limits["fail"], limits["warn"])
        count += len(figures) + 2
        if (status, report["outcome"]) != (int(outcome == "different"), outcome):
            lines.append(f"{words}: {status} {report['outcome']}, not {outcome}")
        lines += [f"{words}: {name} is {report['figures'].get(name)}, not {value}" for name, value in figures.items()
                  if not near(value, report["figures"].get(name))]
        if report["expected"]["channels"] != NAMES[pair.expected.shape[2] - 1]:
            lines.append(f"channels: {report['expected']['channels']}")
    return count
