"""PNG, JPEG, EXR, HDR, TIFF, BMP and TGA files of a few bytes, right or wrong as the caller wishes."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def chunk(kind: bytes, data: bytes, checksum: int | None = None) -> bytes:
    crc = zlib.crc32(kind + data) if checksum is None else checksum
    return struct.pack(">I4s", len(data), kind) + data + struct.pack(">I", crc)


def header(width: int, height: int, depth: int = 8, color: int = 2, interlace: int = 0, compression: int = 0,
           filters: int = 0) -> bytes:
    return chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, color, compression, filters, interlace))


CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
PASSES = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]


def zeros(width: int, height: int, depth: int, color: int, interlace: int) -> bytes:
    """The raw data of a picture of zeros."""
    bits = depth * CHANNELS.get(color, 1)
    size = 0
    for x, y, across, down in PASSES if interlace else [(0, 0, 1, 1)]:
        columns, rows = -(-(width - x) // across), -(-(height - y) // down)
        if columns > 0 and rows > 0:
            size += rows * (1 + (columns * bits + 7) // 8)
    return bytes(size)


def png(width: int, height: int, depth: int = 8, color: int = 2, interlace: int = 0, raw: bytes | None = None,
        between: bytes = b"") -> bytes:
    """`between` stands before the data: a palette, or whatever does not belong there."""
    if raw is None:
        raw = zeros(width, height, depth, color, interlace)
    if color == 3 and b"PLTE" not in between:
        between = chunk(b"PLTE", bytes(range(6))) + between
    return (SIGNATURE + header(width, height, depth, color, interlace) + between +
            chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def marker(code: int, data: bytes = b"") -> bytes:
    return struct.pack(">BBH", 0xFF, code, len(data) + 2) + data


def frame_header(width: int, height: int, components: int, code: int, precision: int = 8, sampling: int = 0x11) -> bytes:
    parts = b"".join(struct.pack("BBB", i + 1, sampling if i == 0 else 0x11, 0) for i in range(components))
    return marker(code, struct.pack(">BHHB", precision, height, width, components) + parts)


def scan_header(components: int, first: int = 0, last: int = 63, bits: int = 0) -> bytes:
    parts = b"".join(struct.pack("BB", i + 1, 0) for i in range(components))
    return marker(0xDA, struct.pack("B", components) + parts + struct.pack("BBB", first, last, bits))


def jpeg(width: int, height: int, components: int = 3, code: int = 0xC0, precision: int = 8, data: bytes | None = None,
         scans: bytes | None = None, extra: bytes = b"") -> bytes:
    """A picture of one colour: a block is a difference of 0 and an end of block, a bit each."""
    tables = (marker(0xDB, b"\0" + b"\1" * 64) + marker(0xC4, b"\x00" + b"\1" + bytes(15) + b"\0") +
              marker(0xC4, b"\x10" + b"\1" + bytes(15) + b"\0"))
    if data is None:
        blocks = -(-width // 8) * -(-height // 8) * components
        data = bytes((blocks * 2 + 7) // 8)
    if scans is None:
        scans = scan_header(components) + data
    return (b"\xff\xd8" + extra + tables + frame_header(width, height, components, code, precision) + scans + b"\xff\xd9")


def progressive(width: int, height: int, scans: int) -> bytes:
    """The same scan of differences again and again."""
    blocks = -(-width // 8) * -(-height // 8)
    one = scan_header(1, 0, 0) + bytes((blocks + 7) // 8)
    return jpeg(width, height, 1, 0xC2, scans=one * scans)


def exr(window: tuple[int, int, int, int], compression: int = 0, tiles: tuple[int, int] | None = None,
        channels: bytes = b"R\0" + struct.pack("<iIii", 2, 0, 1, 1), body: bytes = b"", flags: int = 0) -> bytes:
    def attribute(name: bytes, kind: bytes, value: bytes) -> bytes:
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value

    data = struct.pack("<II", 20000630, 2 | flags | (0x200 if tiles else 0))
    data += attribute(b"channels", b"chlist", channels + b"\0")
    data += attribute(b"compression", b"compression", bytes([compression]))
    data += attribute(b"dataWindow", b"box2i", struct.pack("<4i", *window))
    data += attribute(b"displayWindow", b"box2i", struct.pack("<4i", *window))
    data += attribute(b"lineOrder", b"lineOrder", b"\0")
    data += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    data += attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0))
    data += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1))
    if tiles:
        data += attribute(b"tiles", b"tiledesc", struct.pack("<IIB", *tiles, 0))
    return data + b"\0" + body


def hdr(width: int, height: int, body: bytes = b"") -> bytes:
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode() + body


def tiff(entries: dict[int, tuple[int, int, int]], body: bytes = b"", next_directory: int = 0) -> bytes:
    """Entries: tag to (type, count, value)."""
    directory = struct.pack("<H", len(entries))
    for tag, (kind, count, value) in sorted(entries.items()):
        directory += struct.pack("<HHII", tag, kind, count, value & 0xFFFFFFFF)
    return b"II*\0" + struct.pack("<I", 8) + directory + struct.pack("<I", next_directory) + body


def grey_tiff(width: int, height: int, **more) -> bytes:
    entries = {256: (4, 1, width), 257: (4, 1, height), 258: (3, 1, 8), 259: (3, 1, 1), 262: (3, 1, 1), 273: (4, 1, 8),
               277: (3, 1, 1), 278: (4, 1, height), 279: (4, 1, width * height)}
    entries.update({int(tag[1:]): value for tag, value in more.items()})
    return tiff(entries)


def bmp(width: int, height: int, bits: int = 24, compression: int = 0, size: int = 40) -> bytes:
    return (b"BM" + struct.pack("<IHHI", 70, 0, 0, 54) +
            struct.pack("<IiiHHIIiiII", size, width, height, 1, bits, compression, 0, 0, 0, 0, 0) + bytes(16))


def tga(width: int, height: int, kind: int = 10, bits: int = 24, maps: int = 0, body: bytes = b"") -> bytes:
    return struct.pack("<BBBHHBHHHHBB", 0, maps, kind, 0, 0, 0, 0, 0, width, height, bits, 0) + body
