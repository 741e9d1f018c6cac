"""Pictures: as textures, as surroundings, and for diff."""

import struct
import zlib
from collections.abc import Iterator

import pictures
from calls import Case
from models import textured

SMALL = ["--resolution", "64,64"]
ENVIRONMENT = ["render", "model.gltf", "-o", "out.png", *SMALL, "--background", "environment", "--environment"]


def as_texture(name: str, data: bytes, expect: str = "either", says: str = "", mime: str = "image/png") -> Case:
    expected = "told" if expect == "error" else expect
    return Case(f"texture: {name}", {"model.gltf": textured(data, mime).gltf()}, ["render", "model.gltf", "-o", "out.png", *SMALL],
                expected, says)


def as_others(name: str, data: bytes, file: str, expect: str = "either", says: str = "") -> Iterator[Case]:
    model = textured(pictures.png(2, 2)).gltf()
    yield Case(f"environment: {name}", {"model.gltf": model, file: data}, [*ENVIRONMENT, file], expect, says)
    yield Case(f"diff: {name}", {file: data, "ours.png": pictures.png(2, 2)}, ["diff", file, "ours.png"], expect, says, writes="", fine=(0, 1))


def png_headers() -> Iterator[tuple[str, bytes, str]]:
    """Name, file, what is due."""
    def whole(header: bytes, data: bytes = zlib.compress(bytes(64))) -> bytes:
        return pictures.SIGNATURE + header + pictures.chunk(b"IDAT", data) + pictures.chunk(b"IEND", b"")

    for width, height in [(0, 4), (4, 0), (2**31, 1), (1, 2**31), (2**32 - 1, 2**32 - 1), (2**31 - 1, 2**31 - 1), (16385, 1), (1, 16385), (65536, 65536)]:
        yield f"{width} x {height}", whole(pictures.header(width, height)), "error"
    for depth, color in [(3, 2), (0, 2), (16, 3), (4, 2), (8, 1), (8, 5), (8, 255), (32, 0)]:
        yield f"depth {depth}, colour {color}", whole(pictures.header(4, 4, depth, color)), "error"
    for more in [{"interlace": 2}, {"compression": 1}, {"filters": 1}]:
        yield f"{more}", whole(pictures.header(4, 4, **more)), "error"
    good = pictures.png(4, 4)
    yield "no header", pictures.SIGNATURE + pictures.chunk(b"IEND", b""), "error"
    yield "two headers", good[:33] + pictures.header(4, 4) + good[33:], "error"
    yield "a header of 12 bytes", pictures.SIGNATURE + pictures.chunk(b"IHDR", bytes(12)) + good[33:], "error"
    yield "no data", pictures.SIGNATURE + pictures.header(4, 4) + pictures.chunk(b"IEND", b""), "error"
    yield "wrong checksum of the data", good[:-16] + struct.pack(">I", 1) + good[-12:], "either"
    yield "wrong checksum of the header", good[:29] + b"abcd" + good[33:], "either"
    for length in [*range(1, 60, 6), len(good) - 13, len(good) - 5]:
        yield f"cut at {length}", good[:length], "either"
    yield "behind the end", good + b"x" * 1000, "fine"
    yield "a chunk of 2^31 bytes", good[:33] + struct.pack(">I4s", 2**31, b"tEXt") + good[33:], "error"
    yield "a chunk of 2^32 - 1 bytes", good[:33] + struct.pack(">I4s", 2**32 - 1, b"IDAT") + good[33:], "error"


def png_data() -> Iterator[tuple[str, bytes, str]]:
    yield "a palette that is too short", pictures.png(4, 4, 8, 3, raw=(b"\0" + b"\xff" * 4) * 4), "either"
    yield "a palette of 257", pictures.png(4, 4, 8, 3, between=pictures.chunk(b"PLTE", bytes(771))), "error"
    yield "a palette of 4 bytes", pictures.png(4, 4, 8, 3, between=pictures.chunk(b"PLTE", bytes(4))), "error"
    yield "no palette", pictures.SIGNATURE + pictures.header(4, 4, 8, 3) + pictures.chunk(b"IDAT", zlib.compress(bytes(20))) + pictures.chunk(b"IEND", b""), "error"
    yield "transparency of 300", pictures.png(4, 4, 8, 3, between=pictures.chunk(b"PLTE", bytes(6)) + pictures.chunk(b"tRNS", bytes(300))), "either"
    yield "data that is too short", pictures.png(64, 64, raw=bytes(100)), "either"
    yield "data that is too long", pictures.png(4, 4, raw=bytes(100_000)), "either"
    yield "unknown filters", pictures.png(4, 4, raw=b"\xff" * 52), "either"
    for color in [0, 2, 3, 4, 6]:
        for depth in [1, 2, 4, 8, 16]:
            for interlace in [0, 1]:
                if (depth < 8 and color in (2, 4, 6)) or (depth == 16 and color == 3):
                    continue
                for side in [1, 3, 9]:
                    yield f"{side} x {side}, depth {depth}, colour {color}, interlace {interlace}", pictures.png(side, side, depth, color, interlace), "fine"
    bomb = zlib.compress(bytes(100_000_000), 9)
    for kind, data in [(b"zTXt", b"x\0\0" + bomb), (b"iCCP", b"x\0\0" + bomb), (b"iTXt", b"x\0\1\0\0\0" + bomb)]:
        yield f"a bomb in {kind.decode()}", pictures.png(4, 4, between=pictures.chunk(kind, data)), "either"
    yield "100,000 chunks", pictures.png(4, 4, between=pictures.chunk(b"tEXt", b"a\0b") * 100_000), "either"
    yield "100,000 empty data chunks", pictures.png(4, 4, between=pictures.chunk(b"IDAT", b"") * 100_000), "either"


def jpegs() -> Iterator[tuple[str, bytes, str]]:
    yield "plain", pictures.jpeg(64, 32), "fine"
    yield "grey", pictures.jpeg(64, 32, 1), "fine"
    adobe = pictures.marker(0xEE, b"Adobe\0\x64\0\0\0\0\0")
    for transform in [0, 1, 2, 9]:
        yield f"four inks, {transform}", pictures.jpeg(64, 32, 4, extra=adobe[:-1] + bytes([transform])), "either"
    yield "four inks without a mark", pictures.jpeg(64, 32, 4), "fine"
    for width, height in [(0, 8), (8, 0), (65535, 65535), (65535, 1), (16385, 8), (65500, 65500)]:
        yield f"{width} x {height}", pictures.jpeg(width, height, data=bytes(100)), "error"
    for components in [0, 2, 5, 10, 255]:
        yield f"{components} components", pictures.jpeg(8, 8, components, data=bytes(64)), "error"
    for precision in [0, 12, 16]:
        yield f"precision {precision}", pictures.jpeg(8, 8, precision=precision), "error"
    for code in [0xC1, 0xC3, 0xC5, 0xC9, 0xCA]:
        yield f"frame {code:x}", pictures.jpeg(16, 16, code=code), "either"
    yield "cut before the data", pictures.jpeg(64, 64, data=b"")[:-2], "error"
    good = pictures.jpeg(64, 64)
    for length in range(2, len(good) - 2, 23):
        yield f"cut at {length}", good[:length], "either"
    yield "5000 scans", pictures.progressive(64, 64, 5000), "error"
    yield "90 scans of a large one", pictures.progressive(8192, 4096, 90), "either"
    yield "markers without end", b"\xff\xd8" + pictures.marker(0xE0, bytes(10)) * 100_000 + good[2:], "either"
    yield "restarts", pictures.jpeg(64, 64, extra=pictures.marker(0xDD, struct.pack(">H", 1))), "either"
    yield "a comment of 0 bytes", good[:2] + b"\xff\xfe\0\0" + good[2:], "either"


def bombs() -> Iterator[tuple[str, bytes, str, str]]:
    """Whole, small, and huge when unpacked."""
    for side, expect in [(4096, "either"), (8192, "either"), (16384, "error")]:
        for depth, color in [(1, 0), (8, 3)]:
            if side < 16384 or depth == 1:
                yield f"{side}² zeros, depth {depth}, colour {color}", pictures.png(side, side, depth, color), expect, "x.png"
    yield "16384 x 8192 zeros", pictures.png(16384, 8192, 1, 0), "either", "x.png"
    yield "JPEG 8192²", pictures.jpeg(8192, 8192), "either", "x.jpg"
    yield "JPEG 16384 x 16000", pictures.jpeg(16384, 16000), "either", "x.jpg"
    yield "JPEG 8192 x 4096, progressive", pictures.progressive(8192, 4096, 1), "either", "x.jpg"


def others() -> Iterator[tuple[str, bytes, str]]:
    """Name, file, name of the file: for the formats of the module, whose loading takes long. All are errors."""
    big = 2**31 - 1
    for window in [(0, 0, big, big), (-big - 1, -big - 1, big, big), (0, 0, -2, -2), (5, 5, 4, 4), (0, 0, 16384, 0), (big - 1, big - 1, big, big), (0, 0, 9999, 9999), (0, 0, 15, 15)]:
        for compression in [0, 1, 3, 4, 5, 6, 8, 9, 200]:
            yield f"EXR {window}, compression {compression}", pictures.exr(window, compression), "x.exr"
    for tiles in [(1, 1), (0, 0), (2**32 - 1, 2**32 - 1), (65536, 65536)]:
        yield f"EXR tiles {tiles}", pictures.exr((0, 0, 8191, 4095), tiles=tiles), "x.exr"
    yield "EXR 10,000 channels", pictures.exr((0, 0, 63, 31), channels=b"".join(b"c%05d\0" % i + struct.pack("<iIii", 2, 0, 1, 1) for i in range(10_000))), "x.exr"
    yield "EXR subsampled by 2^31", pictures.exr((0, 0, 63, 31), channels=b"R\0" + struct.pack("<iIii", 2, 0, big, big)), "x.exr"
    yield "EXR deep", pictures.exr((0, 0, 63, 31), flags=0x800), "x.exr"
    yield "EXR of several parts", pictures.exr((0, 0, 63, 31), flags=0x1000), "x.exr"
    yield "EXR with offsets everywhere", pictures.exr((0, 0, 63, 31), body=struct.pack("<Q", 2**63) * 32), "x.exr"
    for width, height in [(big, big), (0, 0), (-5, -5), (16385, 2), (9999999999, 2), (8192, 4096), (64, 32)]:
        yield f"HDR {width} x {height}", pictures.hdr(width, height), "x.hdr"
    yield "HDR runs beyond the row", pictures.hdr(64, 32, (b"\2\2\0\x40" + b"\xff\1" * 200) * 32), "x.hdr"
    yield "HDR without a size", b"#?RADIANCE\n\n", "x.hdr"
    yield "HDR with a long header", b"#?RADIANCE\n" + b"a=b\n" * 500_000, "x.hdr"
    for width, height in [(2**32 - 1, 2**32 - 1), (0, 0), (16385, 2), (16384, 16384)]:
        yield f"TIFF {width} x {height}", pictures.grey_tiff(width, height), "x.tif"
    yield "TIFF of 65535 samples", pictures.grey_tiff(64, 32, _277=(3, 1, 65535)), "x.tif"
    yield "TIFF of 64 bits", pictures.grey_tiff(64, 32, _258=(3, 1, 64)), "x.tif"
    for compression in [2, 34925, 50001, 65535]:
        yield f"TIFF, compression {compression}", pictures.grey_tiff(64, 32, _259=(3, 1, compression)), "x.tif"
    yield "TIFF whose directories go round", pictures.tiff({256: (4, 1, 64)}, next_directory=8), "x.tif"
    yield "TIFF with tiles of 2^31", pictures.grey_tiff(64, 32, _322=(4, 1, 2**31), _323=(4, 1, 2**31), _324=(4, 1, 8), _325=(4, 1, 8)), "x.tif"
    for width, height in [(big, -big - 1), (0, 0), (-1, 4), (16385, 2), (64, 32)]:
        yield f"BMP {width} x {height}", pictures.bmp(width, height), "x.bmp"
    for bits, compression in [(8, 1), (1, 0), (32, 3), (24, 4), (64, 0)]:
        yield f"BMP {bits} bits, compression {compression}", pictures.bmp(64, 32, bits, compression), "x.bmp"
    for kind, bits, maps in [(1, 8, 1), (9, 8, 1), (10, 24, 0), (2, 24, 0), (10, 15, 0), (3, 255, 0), (99, 24, 0)]:
        yield f"TGA {kind}, {bits} bits", pictures.tga(64, 32, kind, bits, maps), "x.tga"
        yield f"TGA {kind}, {bits} bits, 65535²", pictures.tga(65535, 65535, kind, bits, maps, b"\xff" * 64), "x.tga"
    for name, data in [("GIF", b"GIF89a\xff\xff\xff\xff\xf7\0\0"), ("ICO", b"\0\0\1\0\1\0\xff\xff"), ("PSD", b"8BPS\0\1" + bytes(20)), ("zeros", bytes(100)),
                       ("text", b"#!/bin/sh\n"), ("XML", b"<svg xmlns='http://www.w3.org/2000/svg'/>")]:
        for file in ["x.png", "x.exr", "x.gif", "x"]:
            yield f"{name} as {file}", data, file


def settings() -> Iterator[Case]:
    """Files of options."""
    model = textured(pictures.png(2, 2)).gltf()
    texts = [b"", b"{", b"[]", b"null", b"{}" + bytes(10), b'{"shading":' + b"[" * 100_000, b'{"a":1}', b'{"shading":1e999}', b'{"shading":null}', b'{"settings":"s.json"}',
             b'{"resolution":[1e308,1]}', b'{"resolution":"99999,99999"}', b'{"light":["point:pos=nan,0,0"]}', b'{"light":"point:intensity=1e999"}',
             b'{"light":[' + b'"point",' * 50_000 + b'"point"]}', b'{"light":"' + b"point:" * 50_000 + b'"}', b"x" * (1 << 21), b'{"output":"/etc/x"}', b'{"shading":"flat","shading":"flat"}',
             b'{"fog":"exp:-1"}', b'{"ambient":[1,2]}', b'{"\xff":1}', b'{"environment":"/dev/zero"}', b'{"environment":"/proc/self/mem"}', b'{"crease-angle":-0.0}',
             b'{"camera-position":[1e18,1e18,1e18]}', b'{"camera-position":"0,0,0","camera-focal-point":"0,0,1e-30"}', b'{"max-memory":"1T"}', b'{"shading":"\\u0000"}',
             b'{"material":"color=1,1,1:shininess=1e308"}', b'{"time":1e6}', b'{"light":"spot:cone=0,0:exponent=1e18"}']
    for number, text in enumerate(texts):
        yield Case(f"settings {number}: {text[:40]!r}", {"model.gltf": model, "s.json": text},
                   ["render", "model.gltf", "-o", "out.png", *SMALL, "--settings", "s.json"])


def options() -> Iterator[Case]:
    model = textured(pictures.png(2, 2)).gltf()
    for words in [["--max-memory", "0"], ["--max-memory", "-1G"], ["--max-memory", "1e999G"], ["--max-memory", "G"], ["--max-memory", "512"], ["--max-memory", "nanG"],
                  ["--max-seconds", "0"], ["--max-seconds", "-1"], ["--max-seconds", "nan"], ["--max-seconds", "inf"], ["--light", "point:" + ":" * 10_000],
                  ["--light", "directional:dir=0,0,0"], ["--resolution", "0,0"], ["--resolution", "16385,1"], ["--resolution", "2147483648,1"], ["--fog", "linear:5,5:nan,0,0"]]:
        yield Case(f"option {' '.join(words)[:60]}", {"model.gltf": model}, ["render", "model.gltf", "-o", "out.png", *words], "error")
    for words in [["--max-memory", "64M"], ["--max-memory", "100G"], ["--max-seconds", "60"], ["--max-seconds", "1e6"]]:
        yield Case(f"option {' '.join(words)}", {"model.gltf": model}, ["render", "model.gltf", "-o", "out.png", *SMALL, *words], "fine")


def all_cases() -> Iterator[Case]:
    for name, data, expect in [*png_headers(), *png_data()]:
        yield as_texture(name, data, expect)
    for number, (name, data, expect) in enumerate([*png_headers(), *png_data()]):
        if number % 6 == 0 and expect != "fine":
            yield from as_others(name, data, "x.png", expect)
    for name, data, expect in jpegs():
        yield as_texture(f"JPEG {name}", data, expect, mime="image/jpeg")
        yield as_texture(f"JPEG as PNG {name}", data, expect)
    for name, data, expect, file in bombs():
        yield as_texture(name, data, expect)
        yield from (case for case in as_others(name, data, file) if not case.name.startswith("diff"))
    for number, (name, data, file) in enumerate(others()):
        if number % 4 == 0 or file != "x.exr":
            yield list(as_others(name, data, file, "error"))[number % 2]
    yield from as_others("TIFF with a strip beyond the end", pictures.grey_tiff(64, 32, _273=(4, 1, 2**31)), "x.tif")
    yield from settings()
    yield from options()
