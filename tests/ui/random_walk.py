"""A random walk over keys, drags, clicks, wheel and window sizes of barrido-view: it must not end, complain, or hang, and
afterwards quit as it should. With a build that has sanitizers, a report of theirs is a complaint.

usage: random_walk.py PROGRAM_FOLDER PROJECT_FOLDER [--seconds N] [--seed N]      default: 10 s, where CI=true a minute
"""

import argparse
import os
import pathlib
import queue
import random
import sys
import tempfile
import time

import display
from viewer_program import DEADLINE_S, ViewerProgram

# Keys with how often; Escape would quit.
KEYS = ("s shift+s b o k e w n g t i f shift+f m r u x l shift+l j y d shift+d q a shift+a p v v shift+v 1 3 5 7 9 Return Up Left "
        "Right space z h Tab c ctrl+1 ctrl+2 ctrl+3 ctrl+8 ctrl+s ctrl+o F12").split()
MODELS = ["showcase.glb", "room.glb", "checker_ground.glb", "lost_highlight.glb", "torus.glb"]
SIZES = [(640, 400), (333, 517), (1000, 700), (200, 120)]
CHECK_EVERY = 40
ATTEMPTS = 3


class Walk:
    def __init__(self, program: ViewerProgram, chance: random.Random):
        self.program, self.chance = program, chance

    def place(self) -> tuple[int, int]:
        return self.chance.randrange(0, 640), self.chance.randrange(0, 400)

    def step(self) -> None:
        screen, chance = self.program.screen, self.chance
        action = chance.choices(["key", "drag", "click", "wheel", "size"], [10, 5, 2, 2, 0.3])[0]
        if action == "key":
            self.program.key(*(chance.choice(KEYS) for _ in range(chance.randrange(1, 5))))
        elif action == "drag":
            self.program.drag(chance.choice([1, 1, 1, 2, 3]), self.place(), self.place(),
                              chance.choice(["", "", "shift", "ctrl"]))
        elif action == "click":
            screen.xdotool("mousemove", *self.place(), "click", chance.choice([1, 1, 3]))
        elif action == "wheel":
            screen.xdotool("mousemove", *self.place(), "click", "--repeat", chance.randrange(1, 6), "--delay", 5,
                           chance.choice([4, 5]))
        else:
            screen.xdotool("windowsize", self.program.window, *chance.choice(SIZES))

    def alive(self) -> None:
        """Everything sent has been seen; raises AssertionError when the program has ended or hangs."""
        for _ in range(ATTEMPTS):
            # A click takes the keyboard away from a field of the panel.
            self.program.screen.xdotool("mousemove", 20, 20, "click", 1)
            self.program.skip_lines()
            self.program.key("c")
            try:
                self.program.wait_for_line("barrido render")
                return
            except queue.Empty:
                continue
        raise AssertionError("it does not answer any more")

    def quit(self) -> None:
        """As a user does; raises AssertionError when the exit status tells of an error."""
        deadline = time.monotonic() + DEADLINE_S
        while self.program.process.poll() is None and time.monotonic() < deadline:
            self.program.key("Escape")  # The first may close the help.
            time.sleep(0.5)
        if self.program.process.poll() is None:
            raise AssertionError("it does not quit")
        status = self.program.process.wait()
        self.program.reader.join()
        self.program.skip_lines()
        if status != 0:
            raise AssertionError(f"exit status {status}")


def walk(programs: pathlib.Path, project: pathlib.Path, seconds: float, seed: int) -> int:
    screen = display.Display()
    with tempfile.TemporaryDirectory(prefix="barrido-walk-") as folder:
        try:
            return walk_in(pathlib.Path(folder), screen, programs, project, seconds, seed)
        finally:
            screen.close()


def walk_in(folder: pathlib.Path, screen: display.Display, programs: pathlib.Path, project: pathlib.Path,
            seconds: float, seed: int) -> int:
    words = [str(project / "models" / name) for name in MODELS]
    program = ViewerProgram(screen, programs, folder,
                            ["--resolution", "320,400", "--environment", str(project / "models" / "sky"), *words])
    steps, failure = 0, ""
    try:
        one = Walk(program, random.Random(seed))
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            one.step()
            steps += 1
            if steps % CHECK_EVERY == 0:
                one.alive()
        one.alive()
        one.quit()
    except AssertionError as error:
        failure = str(error)
    errors = program.error_text()
    program.stop()
    if failure:
        print(f"seed {seed}, step {steps}: {failure}")
    print(f"{steps} steps in {seconds:g} s, {program.frames} pictures, seed {seed}")
    if errors:
        print(f"it said: {errors}")
    return 1 if errors or failure else 0


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("project", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=60.0 if os.environ.get("CI") == "true" else 10.0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    try:
        return walk(arguments.programs.resolve(), arguments.project.resolve(), arguments.seconds, arguments.seed)
    except display.Missing as missing:
        print(f"skipped: {missing}")
        return 0


if __name__ == "__main__":
    sys.exit(main())
