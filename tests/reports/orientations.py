"""Radiance files in all eight orders of pixels are one picture.

usage: orientations.py BARRIDO
"""

import os
import subprocess
import sys
import tempfile

WIDTH, HEIGHT = 8, 4
COLUMNS, ROWS = list(range(WIDTH)), list(range(HEIGHT))
# The line of the header, and how columns and rows follow each other; the first axis is that of the scanlines.
ORDERS = {f"{y}Y {HEIGHT} {x}X {WIDTH}": [(c, r) for r in ROWS[:: -1 if y == "+" else 1] for c in COLUMNS[:: 1 if x == "+" else -1]]
          for y in "-+" for x in "+-"}
ORDERS |= {f"{x}X {WIDTH} {y}Y {HEIGHT}": [(c, r) for c in COLUMNS[:: 1 if x == "+" else -1] for r in ROWS[:: -1 if y == "+" else 1]]
           for y in "-+" for x in "+-"}


def picture(head: str, order: list[tuple[int, int]]) -> bytes:
    pixels = b"".join(bytes([16 * x + 8, 60 * y + 8, 100, 129]) for x, y in order)
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + head.encode() + b"\n" + pixels


def main() -> int:
    program, failures = os.path.abspath(sys.argv[1]), []
    with tempfile.TemporaryDirectory() as folder:
        for number, (head, order) in enumerate(ORDERS.items()):
            with open(f"{folder}/{number}.hdr", "wb") as file:
                file.write(picture(head, order))
            words = [program, "diff", "--no-flip", "0.hdr", f"{number}.hdr"]
            result = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
            if result.returncode != 0:
                failures.append(f"{head}: {result.stdout}{result.stderr}")
    print("\n".join(failures) or f"{len(ORDERS)} orders, one picture")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
