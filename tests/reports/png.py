"""Reads the PNG files that barrido writes, with nothing but Python's own library."""

import pathlib
import struct
import zlib


def paeth(a: int, b: int, c: int) -> int:
    estimate = a + b - c
    return min((abs(estimate - a), 0, a), (abs(estimate - b), 1, b), (abs(estimate - c), 2, c))[2]


def unfiltered(raw: bytes, pitch: int, height: int, step: int) -> list[bytearray]:
    rows, above = [], bytearray(pitch)
    for y in range(height):
        kind, row = raw[y * (pitch + 1)], bytearray(raw[y * (pitch + 1) + 1 : (y + 1) * (pitch + 1)])
        for i in range(pitch if kind else 0):
            left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
            predicted = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind]
            row[i] = (row[i] + predicted) & 255
        rows.append(row)
        above = row
    return rows


class Picture:
    """8 bits a channel, RGB or RGBA, not interlaced; pixels are tuples of four."""

    def __init__(self, path: pathlib.Path):
        data = path.read_bytes()
        self.width, self.height, bits, kind, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
        assert bits == 8 and kind in (2, 6) and not interlaced
        self.channels = 3 if kind == 2 else 4
        at, packed = 8, b""
        while at < len(data):
            length, name = struct.unpack(">I4s", data[at : at + 8])
            packed += data[at + 8 : at + 8 + length] if name == b"IDAT" else b""
            at += length + 12
        raw = zlib.decompress(packed)
        self.rows = unfiltered(raw, self.width * self.channels, self.height, self.channels)

    def __getitem__(self, place: tuple[int, int]) -> tuple[int, ...]:
        x, y = place
        pixel = tuple(self.rows[y][x * self.channels : (x + 1) * self.channels])
        return pixel if self.channels == 4 else (*pixel, 255)

    @property
    def middle(self) -> tuple[int, ...]:
        return self[self.width // 2, self.height // 2]

    def count(self, wanted) -> int:
        """Pixels for which wanted(pixel) holds."""
        return sum(bool(wanted(self[x, y])) for y in range(self.height) for x in range(self.width))

    def differing(self, other: "Picture") -> int:
        """Pixels that are not the same."""
        return sum(self[x, y] != other[x, y] for y in range(self.height) for x in range(self.width))
