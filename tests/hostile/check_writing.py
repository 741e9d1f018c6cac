"""Ends the program while it writes, and lets it write where nothing can be written: under the final name there is what was there before, or
all that was to be there, never a part.

usage: check_writing.py PROGRAM [--sanitized]
"""

import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable

from models import triangle

OLD = b"what was there before"
HITS = 4  # Of each signal, while the picture is being written
MOST_ROUNDS = 60  # On a busy machine the picture is often finished before the signal comes.
ENDS = {"png": b"IEND\xaeB`\x82", "jpg": b"\xff\xd9"}
FORMATS = ["png", "jpg", "exr", "hdr", "tif"]
SIZE = "2500,2500"  # 19 MB of PNG that is not compressed


class Failures:
    """What went wrong so far."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.checks = 0

    def check(self, fine: bool, text: str) -> None:
        self.checks += 1
        if not fine:
            self.lines.append(text)


def temporary(folder: pathlib.Path) -> list[str]:
    return sorted(path.name for path in folder.rglob(".*"))


def start(program: str, words: list[str], folder: pathlib.Path, before: Callable[[], None] | None = None) -> subprocess.Popen:
    return subprocess.Popen([program, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=before)


def end_while_writing(child: subprocess.Popen, folder: pathlib.Path, number: int, wait_s: float) -> None:
    """Waits for the temporary file, a little longer, and sends the signal."""
    while child.poll() is None and not temporary(folder):
        pass
    time.sleep(wait_s)
    child.send_signal(number)
    child.communicate()


def heed_signals() -> None:
    """Whoever runs this test in the background may have it ignore some, and its children with it."""
    for number in [signal.SIGTERM, signal.SIGINT, signal.SIGHUP]:
        signal.signal(number, signal.SIG_DFL)


def is_whole(name: str, data: bytes, whole_size: int) -> bool:
    ending = ENDS.get(name.rsplit(".", 1)[-1])
    return data == OLD or (len(data) == whole_size and (ending is None or data.endswith(ending)))


def signals(program: str, failures: Failures) -> None:
    numbers = random.Random(1)
    hits = {signal.SIGKILL: 0, signal.SIGTERM: 0, signal.SIGINT: 0, signal.SIGHUP: 0}
    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        folder = pathlib.Path(name)
        (folder / "model.gltf").write_bytes(triangle().gltf())
        words = ["render", "model.gltf", "-o", "out.png", "--compression", "0", "--resolution", SIZE]
        start(program, words, folder).communicate()
        whole_size = (folder / "out.png").stat().st_size
        for number in hits:
            rounds = 0
            while hits[number] < HITS and rounds < MOST_ROUNDS:
                rounds += 1
                (folder / "out.png").write_bytes(OLD)
                child = start(program, words, folder, heed_signals)
                end_while_writing(child, folder, number, numbers.uniform(0, 0.02))
                hits[number] += child.returncode == -number
                failures.check(child.returncode in (0, -number), f"{number!r}: status {child.returncode}")
                failures.check(is_whole("out.png", (folder / "out.png").read_bytes(), whole_size), f"{number!r}: half a picture")
                left = temporary(folder)
                failures.check(number == signal.SIGKILL or not left, f"{number!r}: left {left}")
                for file in left:
                    (folder / file).unlink()
    print("ended while writing, by signal: " + ", ".join(f"{number.name} {count}" for number, count in hits.items()))
    failures.check(min(hits.values()) > 0, "no signal came in time: the picture is too small for this machine")


def outputs(program: str, folder: pathlib.Path) -> list[tuple[str, list[str]]]:
    """Files, and the words that write them, in a folder with a model and two pictures."""
    calls = [(f"out.{kind}", ["render", "model.gltf", "-o", f"out.{kind}", "--resolution", "600,600", "--compression", "0"]) for kind in FORMATS]
    calls.append(("sheet.png", ["render", "model.gltf", "-o", "sheet.png", "--sheet", "--shading", "all", "--resolution", "300,300", "--compression", "0"]))
    for kind in ["png", "exr"]:
        calls.append((f"difference.{kind}", ["diff", "a.png", "b.png", "-o", f"difference.{kind}", "--failpercent", "100"]))
    calls.append(("report/index.html", ["diff", "a.png", "b.png", "--html", "report", "--failpercent", "100"]))
    (folder / "model.gltf").write_bytes(triangle().gltf())
    for picture, more in [("a.png", []), ("b.png", ["--background", "1,0,0"])]:
        start(program, ["render", "model.gltf", "-o", picture, "--resolution", "600,600", *more], folder).communicate()
    return calls


def expect_refused(name: str, what: str, child: subprocess.Popen, folder: pathlib.Path, failures: Failures) -> None:
    lines = child.communicate()[1].decode(errors="replace").splitlines()
    failures.check(child.returncode == 2, f"{what}: {name}: status {child.returncode}: {lines[:3]}")
    failures.check(len(lines) == 1 and lines[0].startswith("barrido: "), f"{what}: {name}: {lines[:3]}")
    failures.check(not temporary(folder), f"{what}: {name}: left {temporary(folder)}")
    if (folder / name).is_file():
        failures.check((folder / name).read_bytes() == OLD, f"{what}: {name}: is not what it was")


def too_large(program: str, failures: Failures) -> None:
    """Files may not grow beyond 500 bytes."""
    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500))

    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        folder = pathlib.Path(name)
        for file, words in outputs(program, folder):
            for old in [True, False]:
                (folder / file).parent.mkdir(exist_ok=True)
                (folder / file).unlink(missing_ok=True)
                if old:
                    (folder / file).write_bytes(OLD)
                expect_refused(file, "file too large", start(program, words, folder, limit), folder, failures)


def full_disk(program: str, failures: Failures) -> None:
    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        small = pathlib.Path(name)
        mounted = os.geteuid() == 0 and subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", name], capture_output=True, check=False).returncode == 0
        if not mounted:
            print("a disk of 256 KB cannot be mounted here: skipped")
            return
        try:
            with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as inputs:
                folder = pathlib.Path(inputs)
                for file, words in outputs(program, folder):
                    for old in [True, False]:
                        target = small / file
                        target.parent.mkdir(exist_ok=True)
                        if old:
                            target.write_bytes(OLD)
                        with open(small / "filler", "wb", buffering=0) as filler:
                            try:
                                while True:
                                    filler.write(bytes(4096))
                            except OSError:
                                pass
                        written = [str(target) if word == file else str(small / "report") if word == "report" else word for word in words]
                        child = start(program, written, folder)
                        expect_refused(str(target), "full disk", child, small, failures)
                        for path in [target, small / "filler"]:
                            path.unlink(missing_ok=True)
        finally:
            subprocess.run(["umount", name], check=True)


def devices(program: str, failures: Failures) -> None:
    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        folder = pathlib.Path(name)
        calls = outputs(program, folder)
        for file, words in calls:
            if "/" in file:
                continue
            (folder / file).symlink_to("/dev/full")
            lines = start(program, words, folder).communicate()[1].decode().splitlines()
            failures.check(len(lines) == 1, f"/dev/full as {file}: {lines[:3]}")
            failures.check((folder / file).is_symlink(), f"/dev/full as {file}: is gone")
            (folder / file).unlink()
        for words in [["render", "model.gltf", "-o", "-"], ["info", "model.gltf"], ["info", "model.gltf", "--json"], ["render", "--help"],
                      ["render", "model.gltf", "--hash"], ["diff", "a.png", "b.png", "--quiet", "--json", "-"], ["inspect", "model.gltf", "--pixel", "5,5"]]:
            with open("/dev/full", "wb") as full:
                run = subprocess.run([program, *words], cwd=folder, stdout=full, stderr=subprocess.PIPE, check=False)
            failures.check(run.returncode == 2 and len(run.stderr.splitlines()) == 1, f"/dev/full as output of {words[0]}: {run.returncode} {run.stderr[:200]!r}")
        os.mkfifo(folder / "pipe.png")
        child = start(program, ["render", "model.gltf", "-o", "pipe.png", "--compression", "0"], folder)
        with open(folder / "pipe.png", "rb", buffering=0) as reader:
            reader.read(1000)
        lines = child.communicate()[1].decode().splitlines()
        failures.check(child.returncode == 2 and len(lines) == 1, f"a pipe whose reader leaves: {child.returncode} {lines[:3]}")


def times(program: str, failures: Failures) -> None:
    """The end of --max-seconds, while frames are drawn and written."""
    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        folder = pathlib.Path(name)
        (folder / "model.gltf").write_bytes(triangle().gltf())
        for seconds in ["0.1", "0.3", "0.5", "0.7"]:
            words = ["render", "model.gltf", "-o", "{frame}.png", "--turntable", "100000", "--resolution", SIZE, "--compression", "0", "--max-seconds", seconds]
            lines = start(program, words, folder).communicate()[1].decode().splitlines()
            failures.check(len(lines) == 1 and "--max-seconds" in lines[0], f"--max-seconds {seconds}: {lines[:3]}")
            failures.check(not temporary(folder), f"--max-seconds {seconds}: left {temporary(folder)}")
            for picture in folder.glob("*.png"):
                failures.check(picture.read_bytes().endswith(ENDS["png"]), f"--max-seconds {seconds}: half a picture")
                picture.unlink()


def main() -> int:
    program = os.path.abspath(sys.argv[1])
    failures = Failures()
    for part in [signals, too_large, full_disk, devices, times]:
        part(program, failures)
    print("\n".join(failures.lines))
    print(f"{failures.checks} checks, {len(failures.lines)} failed")
    return 1 if failures.lines else 0


if __name__ == "__main__":
    sys.exit(main())
