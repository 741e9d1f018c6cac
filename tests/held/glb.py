"""Writes GLB files: arrays in any of glTF's formats become accessors, and the numbers that a reader must find in them are kept."""

import json
import random
import struct
import zlib

import numpy as np

FLOAT = np.float32
CODES = {np.int8: 5120, np.uint8: 5121, np.int16: 5122, np.uint16: 5123, np.uint32: 5125, np.float32: 5126}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def decoded(stored: np.ndarray, normalized: bool) -> np.ndarray:
    """The numbers that stored ones mean (glTF 2.0, section 3.11, for normalized integers)."""
    values = stored.astype(np.float64)
    if not normalized:
        return values
    return np.maximum(values / np.iinfo(stored.dtype).max, -1.0)


def png_of(pixels: np.ndarray) -> bytes:
    """A picture of bytes, of shape (height, width, 1 to 4 channels)."""
    height, width, channels = pixels.shape
    rows = b"".join(b"\0" + pixels[y].tobytes() for y in range(height))

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, 8, (0, 4, 2, 6)[channels - 1], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b"")


class Glb:
    """A file in the making: `tree` is its JSON, `values` the numbers of each accessor, one row an element."""

    def __init__(self, rng: random.Random) -> None:
        self.tree: dict = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": []}
        self.values: list[np.ndarray] = []
        self.pictures: list[np.ndarray] = []  # RGBA bytes
        self._rng = rng
        self._data = bytearray()

    def add(self, kind: str, element: dict) -> int:
        """Appends to an array of the file. Returns the index."""
        elements = self.tree.setdefault(kind, [])
        elements.append(element)
        return len(elements) - 1

    def view(self, data: bytes, stride: int = 0) -> int:
        self._data += bytes(-len(self._data) % 4)
        view = {"buffer": 0, "byteOffset": len(self._data), "byteLength": len(data)}
        if stride:
            view["byteStride"] = stride
        self._data += data
        return self.add("bufferViews", view)

    def accessor(self, rows: np.ndarray, dtype: type = FLOAT, normalized: bool = False, vertex: bool = True,
                 sparse: bool = False) -> int:
        """Rows (count, components) of stored numbers. Those of vertices are interleaved with what is no number; where it may be
        `sparse`, some rows may become 0."""
        rows = np.ascontiguousarray(rows, dtype=dtype)
        count, components = rows.shape
        accessor = {"componentType": CODES[dtype], "count": count, "type": KINDS[components]}
        if normalized:
            accessor["normalized"] = True
        if sparse and self._rng.random() < 0.1:
            accessor["sparse"] = self._sparse(rows)
        else:
            self._place(rows, accessor, vertex)
        if components == 3 and dtype == FLOAT:
            accessor["min"] = rows.min(axis=0).astype(float).tolist()
            accessor["max"] = rows.max(axis=0).astype(float).tolist()
        self.values.append(decoded(rows, normalized))
        return self.add("accessors", accessor)

    def _place(self, rows: np.ndarray, accessor: dict, vertex: bool) -> None:
        size = rows.itemsize * rows.shape[1]
        stride, begin = size, 0
        if vertex:
            stride = size + (-size % 4) + 4 * self._rng.randrange(3)
            begin = 4 * self._rng.randrange(2) if stride - size >= 4 else 0
        block = np.frombuffer(self._rng.randbytes(stride * len(rows)), dtype=np.uint8).reshape(len(rows), stride).copy()
        block[:, begin:begin + size] = rows.view(np.uint8).reshape(len(rows), size)
        accessor["bufferView"] = self.view(block.tobytes(), stride if vertex else 0)
        if begin:
            accessor["byteOffset"] = begin

    def _sparse(self, rows: np.ndarray) -> dict:
        """All elements but a few, which are 0, stand in the sparse part."""
        count = len(rows)
        kept = sorted(self._rng.sample(range(count), max(1, count - 2)))
        left_out = [i for i in range(count) if i not in kept]
        rows[left_out] = 0
        indices = np.array(kept, dtype=np.uint16)
        return {"count": len(kept), "indices": {"bufferView": self.view(indices.tobytes()), "componentType": 5123},
                "values": {"bufferView": self.view(rows[kept].tobytes())}}

    def picture(self, pixels: np.ndarray) -> int:
        """An image. Returns its index."""
        self.pictures.append(pixels)
        return self.add("images", {"bufferView": self.view(png_of(pixels)), "mimeType": "image/png"})

    def bytes(self) -> bytes:
        self._data += bytes(-len(self._data) % 4)
        tree = {**self.tree, "buffers": [{"byteLength": len(self._data)}]}
        text = json.dumps({name: value for name, value in tree.items() if value != []}).encode()
        text += b" " * (-len(text) % 4)
        return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self._data)) + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(self._data), b"BIN\0") + self._data)
