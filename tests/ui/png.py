"""Reads the PNG files that `barrido` writes: 8 bits a channel, RGB or RGBA, not interlaced."""

import pathlib
import struct
import zlib


def read(path: pathlib.Path) -> tuple[int, int, bytes]:
    """Width, height and RGBA bytes, top row first."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        chunk = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
            assert depth == 8 and color in (2, 6) and not interlaced
        elif kind == b"IDAT":
            packed += chunk
        place += length + 12
    channels = 3 if color == 2 else 4
    rows = unfiltered(zlib.decompress(packed), width * channels, height, channels)
    rgba = bytearray(b"\xff" * (width * height * 4))
    for channel in range(channels):
        rgba[channel::4] = rows[channel::channels]
    return width, height, bytes(rgba)


def unfiltered(data: bytes, line_bytes: int, height: int, step: int) -> bytearray:
    """PNG's five filters undone (PNG specification, section 9)."""
    result = bytearray()
    previous = bytearray(line_bytes)
    for row in range(height):
        begin = row * (line_bytes + 1)
        kind, line = data[begin], bytearray(data[begin + 1:begin + 1 + line_bytes])
        for i in range(line_bytes if kind else 0):
            left = line[i - step] if i >= step else 0
            up = previous[i]
            corner = previous[i - step] if i >= step else 0
            line[i] = (line[i] + (left, up, (left + up) // 2, paeth(left, up, corner))[kind - 1]) & 255
        result += line
        previous = line
    return result


def paeth(left: int, up: int, corner: int) -> int:
    guess = left + up - corner
    return min((left, up, corner), key=lambda value: abs(guess - value))
