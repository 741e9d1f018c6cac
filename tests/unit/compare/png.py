"""PNG files, written and read with nothing but Python's own library: for checks that must not trust Barrido's."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
COLOR_TYPES = {1: 0, 2: 4, 3: 2, 4: 6}  # by the number of channels


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write(path, width: int, height: int, channels: int, sample, bits: int = 8) -> None:
    """`sample(x, y, c)` is the value of channel c, a whole number of `bits` bits (8 or 16)."""
    form = ">H" if bits == 16 else ">B"
    rows = b"".join(
        b"\0" + b"".join(struct.pack(form, sample(x, y, c)) for x in range(width) for c in range(channels))
        for y in range(height)
    )
    header = struct.pack(">IIBBBBB", width, height, bits, COLOR_TYPES[channels], 0, 0, 0)
    with open(path, "wb") as file:
        file.write(SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def read(data: bytes):
    """(width, height, pixel) of an 8-bit RGB or RGBA picture that is not interlaced; pixel(x, y) is a tuple."""
    width, height, bits, color_type, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    assert bits == 8 and color_type in (2, 6) and not interlaced
    channels = 3 if color_type == 2 else 4
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        packed += data[at + 8 : at + 8 + length] if kind == b"IDAT" else b""
        at += length + 12
    rows = unfiltered(zlib.decompress(packed), width * channels, height, channels)
    return width, height, lambda x, y: tuple(rows[y][x * channels : x * channels + 3])


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
