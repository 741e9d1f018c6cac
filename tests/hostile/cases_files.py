"""Names of files that lead elsewhere, and things that are no files."""

import base64
import json
import os
import pathlib
import socket
from collections.abc import Callable, Iterator

import pictures
from calls import Case
from models import Model, textured, triangle

RENDER = ["render", "in/model.gltf", "-o", "out.png", "--resolution", "64,64"]


def with_uri(uri: str, array: str) -> bytes:
    """The triangle whose buffer, or whose picture, is at `uri`."""
    if array == "buffers":
        model = triangle()
        model.document["buffers"] = [{"uri": uri, "byteLength": len(model.data)}]
        return json.dumps(model.document).encode()
    model = textured(pictures.png(2, 2))
    model.document["images"] = [{"uri": uri}]
    return model.gltf()


def uri_case(name: str, uri: str, expect: str = "error", says: str = "", prepare: Callable[[pathlib.Path], None] | None = None,
             arrays: tuple[str, ...] = ("buffers", "images")) -> Iterator[Case]:
    """In a folder in/ beside which lie files that would do."""
    good = {"buffers": bytes(triangle().data), "images": pictures.png(2, 2)}
    for array in arrays:
        files = {"in/model.gltf": with_uri(uri, array), "in/good": good[array], "in/sub/good": good[array],
                 "in/a b%41": good[array], "outside": good[array], "in2/good": good[array]}
        # What is missing of a buffer cannot be drawn; a material can be drawn without a picture.
        expected = "warned" if array == "images" and expect == "error" else expect
        yield Case(f"{array}: {name}", files, RENDER, expected, says, prepare)


def link(target: str, name: str) -> Callable[[pathlib.Path], None]:
    return lambda folder: os.symlink(target.replace("FOLDER", str(folder)), folder / name)


def pipe(folder: pathlib.Path) -> None:
    os.mkfifo(folder / "in/thing")


def unix_socket(folder: pathlib.Path) -> None:
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(str(folder / "in/thing"))


def big(folder: pathlib.Path) -> None:
    """A file of holes."""
    with open(folder / "in/thing", "wb") as file:
        file.truncate(1 << 40)


def inside() -> Iterator[Case]:
    for name, uri in [("plain", "good"), ("a dot", "./good"), ("a folder", "sub/good"), ("up and down again", "sub/../good"),
                      ("percent-encoded", "%67ood"), ("a blank and a percent sign", "a%20b%2541"), ("slashes", "sub//good")]:
        yield from uri_case(name, uri, "fine")
    yield from uri_case("a link inside", "thing", "fine", prepare=link("good", "in/thing"))


def outside() -> Iterator[Case]:
    leaves = "leaves the model's folder"
    for name, uri in [("up", "../outside"), ("up in the middle", "sub/../../outside"), ("up, encoded", "%2e%2e/outside"),
                      ("up, the slash encoded", "..%2Foutside"), ("up, both encoded", "%2e%2e%2foutside"), ("up from nowhere", "no/../../outside"),
                      ("a folder whose name begins alike", "../in2/good"), ("up, a dot before", "./../outside"), ("up, twice the slash", "..//outside")]:
        yield from uri_case(name, uri, "error", leaves)
    for name, uri in [("up, encoded twice", "%252e%252e/outside"), ("backslashes", "..\\outside"), ("a drive", "C:\\outside"),
                      ("a query", "good?x"), ("a fragment", "good#x"), ("overlong dots", "%c0%ae%c0%ae/outside")]:
        yield from uri_case(name, uri)
    for scheme in ["file:good", "file://good", "file:///etc/passwd", "FILE:///etc/passwd", "http://localhost/x", "https://localhost/x", "ftp://x/y",
                   "javascript:0", "//localhost/good", "data:", "data", "DATA:,x"]:
        yield from uri_case(f"scheme {scheme}", scheme)
    for path in ["/etc/passwd", "/dev/zero", "/dev/stdin", "/dev/tty", "/proc/self/mem", "/proc/self/environ", "/proc/self/fd/0", "/"]:
        yield from uri_case(f"absolute {path}", path, "error", "absolute")
        yield from uri_case(f"absolute, encoded {path}", path.replace("/", "%2F"), "error", "absolute")
    for target in ["FOLDER/outside", "../outside", "/etc/passwd", "/dev/zero", "/proc/self/environ", "FOLDER"]:
        yield from uri_case(f"a link to {target}", "thing", "error", prepare=link(target, "in/thing"))
    yield from uri_case("a linked folder", "thing/outside", "error", leaves, prepare=link("..", "in/thing"))
    yield from uri_case("a link to itself", "thing", "error", prepare=link("thing", "in/thing"))


def no_files() -> Iterator[Case]:
    for name, uri in [("empty", ""), ("a dot alone", "."), ("dots alone", ".."), ("a folder", "sub"), ("a folder with a slash", "sub/"), ("below a file", "good/x"),
                      ("a zero byte", "good%00"), ("a zero byte in the middle", "go%00od"), ("long", "x" * 5000), ("longer", "x/" * 50_000),
                      ("long in percents", "%41" * 20_000), ("a broken percent", "%"), ("broken percents", "%zz%1"), ("line feeds", "a\nb\r\tc"),
                      ("escapes", "\x1b[2J\x07"), ("not there", "nothing")]:
        yield from uri_case(name, uri)
    for name, prepare in [("a pipe", pipe), ("a socket", unix_socket)]:
        yield from uri_case(name, "thing", "error", "is not a regular file", prepare)
    yield from uri_case("a terabyte of holes", "thing", "error", "", big)


def data_uris() -> Iterator[Case]:
    good = base64.b64encode(bytes(triangle().data)).decode()
    for name, uri in [("no comma", "data:application/octet-stream;base64"), ("no data", "data:;base64,"), ("one letter", "data:;base64,A"),
                      ("other letters", "data:;base64,A?=="), ("padding in the middle", "data:;base64,AA==" + good),
                      ("cut", "data:;base64," + good[:20]),
                      ("no base64", "data:,abc"), ("bad percents", "data:,%zz%"), ("padding only", "data:;base64,===="), ("a million commas", "data:" + "," * 1_000_000)]:
        yield from uri_case(f"data {name}", uri)
    for name, uri in [("another case", "DATA:;BASE64," + good), ("blanks", "data:;base64," + " ".join(good)), ("line ends", "data:;base64," + "\r\n".join(good)),
                      ("percents", "data:;base64," + "".join(f"%{ord(c):02x}" for c in good))]:
        yield from uri_case(f"data with {name}", uri, "fine", arrays=("buffers",))
    yield from uri_case("data without padding", "data:;base64," + good.rstrip("="), "fine", arrays=("buffers",))


def models() -> Iterator[Case]:
    """What is given in place of a model."""
    for name, words, prepare in [
            ("a folder", ["in"], lambda folder: (folder / "in").mkdir()), ("nothing", ["nothing"], None), ("a device", ["/dev/zero"], None),
            ("a process", ["/proc/self/mem"], None), ("standard input", ["-"], None), ("an empty name", [""], None), ("a pipe", ["in/thing"],
            lambda folder: ((folder / "in").mkdir(), pipe(folder))), ("a long name", ["x" * 500], None), ("a name with line feeds", ["a\nb\x1b[2J"], None),
            ("a terabyte of holes", ["in/thing"], lambda folder: ((folder / "in").mkdir(), big(folder)))]:
        for command in [["render", *words, "-o", "out.png"], ["info", *words], ["inspect", *words, "--pixel", "1,1"], ["diff", *words, *words]]:
            yield Case(f"{command[0]} {name}", {}, command, "error", prepare=prepare)
    for other in ["png", "bin", "txt"]:
        data = pictures.png(2, 2) if other == "png" else b"\0" * 100
        yield Case(f"a {other} as a model", {f"x.{other}": data}, ["render", f"x.{other}", "-o", "out.png"], "error")


def all_cases() -> Iterator[Case]:
    for part in [inside, outside, no_files, data_uris, models]:
        yield from part()
