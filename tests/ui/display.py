"""A screen of its own for a test: an X server without a monitor, the keys and the mouse of a user, and what the screen
shows. Knows nothing of the program under test.
"""

import ctypes
import hashlib
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile


class Missing(Exception):
    """A program that the tests need is not there."""


class Display:
    """Xvfb on a number that it chooses itself, so that tests can run beside each other."""

    def __init__(self, width: int = 1280, height: int = 800):
        for program in ("Xvfb", "xdotool"):
            if shutil.which(program) is None:
                raise Missing(f"{program} is not installed")
        self._folder = tempfile.TemporaryDirectory()
        read_end, write_end = os.pipe()
        # Without -noreset everything would be forgotten when the last program goes.
        command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp",
                   "-noreset", "-fbdir", self._folder.name]
        self._server = subprocess.Popen(command, pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Missing("Xvfb does not start")
        self.corner = (width - 1, height - 1)
        self.environment = {**os.environ, "DISPLAY": f":{number}", "LIBGL_ALWAYS_SOFTWARE": "1"}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.environment.pop("XAUTHORITY", None)

    def close(self) -> None:
        self._server.terminate()
        self._server.wait()
        self._folder.cleanup()

    def xdotool(self, *words: object) -> str:
        result = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True,
                                timeout=60, check=False)
        if result.returncode != 0:
            raise RuntimeError(f"xdotool {' '.join(map(str, words))}: {result.stderr.strip()}")
        return result.stdout

    def set_dpi(self, dpi: int) -> None:
        """As desktops tell programs how dense their screen is; 96 is usual, 192 a screen of twice the density."""
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        x11.XDefaultRootWindow.restype = x11.XInternAtom.restype = ctypes.c_ulong
        connection = ctypes.c_void_p(x11.XOpenDisplay(self.environment["DISPLAY"].encode()))
        text = f"Xft.dpi:\t{dpi}\n".encode()
        resources = ctypes.c_ulong(x11.XInternAtom(connection, b"RESOURCE_MANAGER", 0))
        string, bits, replace = ctypes.c_ulong(31), 8, 0  # XA_STRING, PropModeReplace
        x11.XChangeProperty(connection, ctypes.c_ulong(x11.XDefaultRootWindow(connection)), resources, string, bits,
                            replace, text, len(text))
        x11.XCloseDisplay(connection)

    def pixels(self, width: int, height: int) -> bytes:
        """The upper left corner of the screen as RGBA bytes, top row first, alpha 255."""
        # The server keeps the screen in a file in the format of xwd: a header of big-endian numbers, a name, colours.
        data = pathlib.Path(self._folder.name, "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", data[:100])
        header_size, bits_per_pixel, bytes_per_line, colors = header[0], header[11], header[12], header[19]
        assert bits_per_pixel == 32, bits_per_pixel
        begin = header_size + colors * 12
        rgba = bytearray()
        for row in range(height):
            line = data[begin + row * bytes_per_line:][:width * 4]
            pixels = bytearray(b"\xff" * (width * 4))
            pixels[0::4], pixels[1::4], pixels[2::4] = line[2::4], line[1::4], line[0::4]
            rgba += pixels
        return bytes(rgba)


def sha256(rgba: bytes) -> str:
    return hashlib.sha256(rgba).hexdigest()


def write_ppm(path: pathlib.Path, width: int, height: int, rgba: bytes) -> None:
    rgb = bytearray(width * height * 3)
    rgb[0::3], rgb[1::3], rgb[2::3] = rgba[0::4], rgba[1::4], rgba[2::4]
    path.write_bytes(b"P6 %d %d 255\n" % (width, height) + rgb)
