"""barrido-view running on a screen, driven by keys and mouse, with what it reports. Waits are for lines of its report
and for the screen to be as expected, with a deadline that only a failing test reaches.
"""

import pathlib
import queue
import re
import shlex
import subprocess
import threading
import time

import display
import png

DEADLINE_S = 60.0
LEAKS = pathlib.Path(__file__).resolve().parents[1] / "sanitizers/lsan.supp"
FRAME = re.compile(r"frame (\d+) drawn (\d+)x(\d+)( coarse)?")


def sanitizer_environment(programs: pathlib.Path) -> dict[str, str]:
    """What a build with LeakSanitizer needs so that it tells of the program's own leaks only."""
    cache = programs / "CMakeCache.txt"
    if not cache.exists() or "-fsanitize=address" not in cache.read_text():
        return {}
    environment = {"LSAN_OPTIONS": f"suppressions={LEAKS}:print_suppressions=0"}
    # Mesa's driver keeps a few things for ever, and is unloaded before anybody looks at what points to them.
    drivers = sorted(map(str, pathlib.Path("/usr/lib").glob("*-linux-gnu/dri/swrast_dri.so")))
    if drivers:
        environment["LD_PRELOAD"] = drivers[0]
    return environment


class Frame:
    def __init__(self, match: re.Match):
        self.number, self.width, self.height = int(match[1]), int(match[2]), int(match[3])
        self.coarse = match[4] is not None


class ViewerProgram:
    """`barrido-view --report WORDS…` on `screen`, its window in the upper left corner with the keyboard."""

    def __init__(self, screen: display.Display, programs: pathlib.Path, folder: pathlib.Path, words: list[str]):
        self.screen, self.programs, self.folder = screen, programs, folder
        self.lines: queue.Queue[str | None] = queue.Queue()
        self.frame: Frame | None = None
        self.frames = 0
        self.errors = open(folder / "errors.txt", "w+", encoding="utf-8")
        environment = {**screen.environment, **sanitizer_environment(programs)}
        self.process = subprocess.Popen([programs / "barrido-view", "--report", *words], cwd=folder, env=environment,
                                        stdout=subprocess.PIPE, stderr=self.errors, text=True)
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()
        self.wait_for_frame()
        self.window = screen.xdotool("search", "--sync", "--onlyvisible", "--name", "barrido-view").split()[0]
        screen.xdotool("windowmove", "--sync", self.window, 0, 0)
        screen.xdotool("windowfocus", "--sync", self.window)
        screen.xdotool("mousemove", "--sync", 100, 100)

    def _read(self) -> None:
        for line in self.process.stdout:
            self.lines.put(line.rstrip("\n"))
        self.lines.put(None)

    def error_text(self) -> str:
        self.errors.seek(0)
        return self.errors.read()

    def next_line(self, timeout_s: float = DEADLINE_S) -> str:
        line = self.lines.get(timeout=timeout_s)
        if line is None:
            self.lines.put(None)
            raise AssertionError(f"barrido-view ended with {self.process.wait()}: {self.error_text()}")
        self._see(line)
        return line

    def _see(self, line: str) -> None:
        match = FRAME.match(line)
        if match:
            self.frame = Frame(match)
            self.frames = self.frame.number

    def skip_lines(self) -> None:
        """All that was reported so far."""
        while not self.lines.empty():
            line = self.lines.get()
            if line is None:
                self.lines.put(None)
                return
            self._see(line)

    def wait_for_line(self, beginning: str) -> str:
        while True:
            line = self.next_line()
            if line.startswith(beginning):
                return line

    def wait_for_frame(self) -> Frame:
        """The next picture at full resolution."""
        while True:
            if FRAME.match(self.next_line()) and not self.frame.coarse:
                return self.frame

    def key(self, *names: str) -> None:
        self.screen.xdotool("key", "--clearmodifiers", "--delay", 20, *names)

    def draw_key(self, name: str) -> None:
        """A key that changes the picture."""
        self.key(name)
        self.wait_for_frame()

    def drag(self, button: int, begin: tuple[int, int], end: tuple[int, int], modifier: str = "") -> None:
        words: list[object] = ["mousemove", *begin]
        if modifier:
            words += ["keydown", modifier]
        words += ["mousedown", button, "mousemove", (begin[0] + end[0]) // 2, (begin[1] + end[1]) // 2,
                  "mousemove", *end, "mouseup", button]
        if modifier:
            words += ["keyup", modifier]
        self.screen.xdotool(*words)

    def command_line(self) -> list[str]:
        """What the program copies when asked, as words; everything sent before has been seen by then."""
        self.key("c")
        return shlex.split(self.wait_for_line("barrido render"))

    def rendered_hash(self, words: list[str]) -> str:
        """The hash that the command line gives, without its output."""
        end = words.index("--")
        without_output = words[1:end - 2] + ["--hash"] + words[end:]
        result = subprocess.run([self.programs / "barrido", *without_output], cwd=self.folder, capture_output=True,
                                text=True, timeout=600, check=True)
        return result.stdout.split()[0]

    def rendered_picture(self) -> bytes:
        """RGBA of what the copied command line draws."""
        words = self.command_line()
        subprocess.run([self.programs / "barrido", *words[1:]], cwd=self.folder, timeout=600, check=True)
        return png.read(self.folder / words[words.index("-o") + 1])[2]

    def settled_pixels(self) -> bytes:
        """The picture on the screen once it stands still."""
        self.screen.xdotool("mousemove", *self.screen.corner)
        words = self.command_line()
        deadline = time.monotonic() + DEADLINE_S
        pixels, unchanged = b"", 0
        while unchanged < 3 and time.monotonic() < deadline:
            before, pixels = pixels, self.shown(words)[2]
            unchanged = unchanged + 1 if pixels == before else 0
            time.sleep(0.1)
        return pixels

    def shown(self, words: list[str]) -> tuple[int, int, bytes]:
        width, height = map(int, words[words.index("--resolution") + 1].split(","))
        if "--view" in words:
            height = self.frame.height  # With the legend.
        return width, height, self.screen.pixels(width, height)

    def expect_equal_pixels(self, what: str) -> None:
        """The picture on the screen is the one that the copied command line renders."""
        self.screen.xdotool("mousemove", *self.screen.corner)  # The pointer would be in the picture.
        words = self.command_line()
        wanted = self.rendered_hash(words)
        deadline = time.monotonic() + DEADLINE_S / 3
        while True:
            width, height, pixels = self.shown(words)
            if display.sha256(pixels) == wanted:
                return
            if time.monotonic() > deadline:
                break
            time.sleep(0.1)  # The server may be behind the report.
        path = self.folder / "shown.ppm"
        display.write_ppm(path, width, height, pixels)
        raise AssertionError(f"{what}: the screen ({path}) is not what this renders: {shlex.join(words)}")

    def close(self) -> int:
        """Quits by the key. @return the exit status."""
        self.key("Escape")
        status = self.process.wait(timeout=DEADLINE_S)
        return status

    def stop(self) -> None:
        """Ends the program if it still runs."""
        self.process.kill()
        self.process.wait()
        self.reader.join()
        self.process.stdout.close()
        self.errors.close()
