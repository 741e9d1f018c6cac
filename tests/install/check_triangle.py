"""Checks the picture that examples/triangle writes against the triangle's own arithmetic.

usage: check_triangle.py FILE.ppm
"""

import sys

WIDTH, HEIGHT = 320, 240
CORNERS = [(-0.75, -0.75), (0.75, -0.75), (0.0, 0.75)]
BACKGROUND = (51, 51, 51)


def weights(x: int, y: int) -> list[float]:
    """Barycentric coordinates of the centre of pixel (x, y), y counted from the top."""
    px = 2.0 * (x + 0.5) / WIDTH - 1.0
    py = 1.0 - 2.0 * (y + 0.5) / HEIGHT
    (ax, ay), (bx, by), (cx, cy) = CORNERS
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    a = ((bx - px) * (cy - py) - (cx - px) * (by - py)) / area
    b = ((cx - px) * (ay - py) - (ax - px) * (cy - py)) / area
    return [a, b, 1.0 - a - b]


def problems(pixels: bytes) -> list[str]:
    found = []
    margin = 0.01  # Pixels this close to an edge may be either.
    for y in range(HEIGHT):
        for x in range(WIDTH):
            actual = tuple(pixels[3 * (y * WIDTH + x) :][:3])
            inside = weights(x, y)
            if min(inside) > margin:
                expected = tuple(round(255 * w) for w in inside)
            elif min(inside) < -margin:
                expected = BACKGROUND
            else:
                continue
            if max(abs(a - e) for a, e in zip(actual, expected)) > 1:
                found.append(f"pixel ({x}, {y}) is {actual}, expected {expected}")
    return found


def main() -> int:
    with open(sys.argv[1], "rb") as file:
        header = file.readline().split()
        pixels = file.read()
    if header != [b"P6", b"320", b"240", b"255"] or len(pixels) != 3 * WIDTH * HEIGHT:
        print(f"{sys.argv[1]}: header {header}, {len(pixels)} bytes of pixels")
        return 1
    found = problems(pixels)
    for problem in found[:10]:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
