"""The real window on a screen without a monitor: after keys, drags and changes of size it shows exactly the pixels that
the copied command line renders.

usage: window_test.py PROGRAM_FOLDER PROJECT_FOLDER [unittest options]
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import display
from viewer_program import ViewerProgram

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
PROJECT = pathlib.Path(sys.argv[2]).resolve()
MODELS = PROJECT / "models"
# Small, so that slow machines are quick enough.
SIZE = ["--resolution", "320,240"]


class WindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        try:
            cls.screen = display.Display()
        except display.Missing as missing:
            raise unittest.SkipTest(f"no virtual display: {missing}")

    @classmethod
    def tearDownClass(cls):
        cls.screen.close()

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="barrido-view-"))

        self.addCleanup(self.remove_folder)

    def remove_folder(self):
        """Unless it holds a picture that was not as it should be."""
        if not (self.folder / "shown.ppm").exists():
            shutil.rmtree(self.folder)

    def start(self, *words: object, panel: bool = False, screen: display.Display | None = None) -> ViewerProgram:
        size = SIZE if "--resolution" not in words else []
        hidden = [] if panel else ["--no-panel"]
        program = ViewerProgram(screen or self.screen, PROGRAMS, self.folder, [*hidden, *size, *map(str, words)])
        self.addCleanup(program.stop)
        return program

    def test_first_picture(self):
        program = self.start(MODELS / "teapot.glb")
        self.assertEqual((program.frame.width, program.frame.height), (320, 240))
        program.expect_equal_pixels("first picture")
        self.assertEqual(program.close(), 0)
        self.assertEqual((self.folder / "errors.txt").read_text(), "")

    def test_keys(self):
        program = self.start(MODELS / "showcase.glb", "--environment", MODELS / "sky")
        # Every key that changes the picture, some of them together.
        for keys in (["s"], ["s", "b", "o"], ["shift+s", "e"], ["t", "w"], ["w", "t", "i"], ["f", "m"],
                     ["shift+f", "k"], ["n", "g"], ["g", "r"], ["r", "x"], ["r", "u"], ["ctrl+1"],
                     ["ctrl+2", "l"], ["shift+l", "j"], ["y"], ["5"], ["1"], ["7"], ["5"], ["Return"]):
            for key in keys:
                program.draw_key(key)
            program.expect_equal_pixels("+".join(keys))
        program.close()

    def test_views(self):
        program = self.start(MODELS / "checker_square.glb")
        seen = []
        for _ in range(14):
            program.draw_key("v")
            program.expect_equal_pixels("view")
            words = program.command_line()
            seen.append(words[words.index("--view") + 1])
        self.assertEqual(len(set(seen)), 14)
        program.draw_key("v")
        self.assertNotIn("--view", program.command_line())
        program.close()

    def test_drags(self):
        program = self.start(MODELS / "room.glb")
        program.drag(1, (160, 120), (200, 90))
        program.expect_equal_pixels("orbit")
        program.drag(1, (160, 120), (130, 150), "shift")
        program.expect_equal_pixels("pan")
        program.drag(1, (200, 120), (180, 190), "ctrl")
        program.expect_equal_pixels("roll")
        program.drag(3, (160, 120), (160, 90))
        program.drag(2, (160, 120), (150, 120))
        program.expect_equal_pixels("zoom and pan")
        program.screen.xdotool("click", 4)
        program.screen.xdotool("click", 4)
        program.key("5")
        program.screen.xdotool("click", 5)
        program.expect_equal_pixels("wheel")
        words = program.command_line()
        for option in ("--camera-index", "--camera-position", "--camera-focal-point", "--camera-up",
                       "--orthographic-height"):
            self.assertIn(option, words)
        program.close()

    @staticmethod
    def numbers(words: list[str], option: str) -> list[float]:
        return [float(number) for number in words[words.index(option) + 1].split(",")]

    def test_drags_have_directions(self):
        """The scene follows the pointer; the wheel, turned forwards, comes nearer."""
        start = ["--camera-position", "0,0,10", "--camera-focal-point", "0,0,0"]
        program = self.start(MODELS / "sphere.glb", *start)

        def after(act) -> tuple[list[float], list[float]]:
            program.draw_key("Return")
            act()
            words = program.command_line()
            return self.numbers(words, "--camera-position"), self.numbers(words, "--camera-focal-point")

        eye, _ = after(lambda: program.drag(1, (160, 120), (220, 120)))
        self.assertLess(eye[0], -1.0)
        eye, _ = after(lambda: program.drag(1, (160, 120), (160, 160)))
        self.assertGreater(eye[1], 1.0)
        eye, focus = after(lambda: program.drag(1, (160, 120), (200, 150), "shift"))
        # 240 pixels are 2·10·tan(15°) at the focal point.
        unit = 2 * 10 * 0.2679492 / 240
        for place in (eye, focus):
            self.assertAlmostEqual(place[0], -40 * unit, 4)
            self.assertAlmostEqual(place[1], 30 * unit, 4)
        eye, _ = after(lambda: program.screen.xdotool("click", 4))
        self.assertLess(eye[2], 9.0)
        eye, _ = after(lambda: program.drag(3, (160, 120), (160, 100)))
        self.assertLess(eye[2], 9.0)
        program.close()

    def test_inspector(self):
        program = self.start(MODELS / "showcase.glb", "--resolution", "900,500")
        picture = program.rendered_picture()
        program.screen.xdotool("mousemove", 50, 60)
        program.key("p")
        for x, y in ((50, 60), (200, 130), (120, 300)):  # Off the window with the story.
            program.screen.xdotool("mousemove", x, y)
            at = (y * 900 + x) * 4
            red, green, blue = picture[at:at + 3]
            self.assertEqual(program.wait_for_line(f"pixel {x},{y} "), f"pixel {x},{y} left {red} {green} {blue}")
        program.screen.xdotool("click", 1, "mousemove", 200, 130)  # A click holds the pixel.
        program.key("c")
        line = ""
        while not line.startswith("barrido render"):
            line = program.next_line()
            self.assertFalse(line.startswith("pixel 200,130"), line)
        program.close()

    def test_resolution_comes_back(self):
        """While a drag moves, pictures may be coarse; when it rests or ends, they are not."""
        screen = display.Display(1920, 1400)
        self.addCleanup(screen.close)
        program = self.start(MODELS / "showcase.glb", "--resolution", "1900,1300", "--environment", MODELS / "sky",
                             screen=screen)
        screen.xdotool("mousemove", 900, 600, "mousedown", 1)
        for x in range(920, 1000, 20):
            screen.xdotool("mousemove", x, 600)
            program.wait_for_line("frame")
            self.assertEqual(program.frame.coarse, program.frame.width < 1900)
        if program.frame.coarse:
            program.wait_for_frame()  # The button is still down.
        self.assertEqual((program.frame.width, program.frame.height), (1900, 1300))
        screen.xdotool("mousemove", 1010, 610, "mouseup", 1)
        program.expect_equal_pixels("after the drag")
        program.close()

    def test_size(self):
        program = self.start(MODELS / "torus.glb", panel=True)
        self.assertEqual(program.frame.width, 320)
        for width, height in ((901, 333), (700, 512)):
            program.screen.xdotool("windowsize", "--sync", program.window, width, height)
            while (program.frame.width, program.frame.height) != (width - 320, height):
                program.wait_for_frame()
            program.expect_equal_pixels(f"{width} x {height}")
        program.key("Tab")
        while program.frame.width != 700:
            program.wait_for_frame()
        program.expect_equal_pixels("without panel")
        program.close()

    def test_larger_letters(self):
        program = self.start(MODELS / "torus.glb", "--scale", "2", panel=True)
        self.assertEqual((program.frame.width, program.frame.height), (320, 240))
        program.expect_equal_pixels("scale 2")
        program.close()

    def test_dense_screen(self):
        """Letters, panel and what can be grabbed are twice as large; pixels stay pixels."""
        screen = display.Display()
        self.addCleanup(screen.close)
        screen.set_dpi(192)
        program = self.start(MODELS / "lost_highlight.glb", panel=True, screen=screen)
        self.assertEqual((program.frame.width, program.frame.height), (320, 240))
        geometry = screen.xdotool("getwindowgeometry", "--shell", program.window)
        self.assertIn(f"WIDTH={320 + 2 * 320}", geometry)
        program.expect_equal_pixels("first picture")
        program.drag(1, (160, 120), (200, 100))
        program.expect_equal_pixels("orbit")
        program.draw_key("d")
        program.draw_key("s")
        left = program.rendered_picture()
        program.key("shift+a")
        right = program.rendered_picture()
        program.drag(1, (169, 150), (89, 150))  # Nine pixels beside the divider, which scale 1 would not take.
        program.wait_for_frame()
        self.expect_split(program, left, right, 89, 60)
        program.close()

    def test_idle_costs_nothing(self):
        program = self.start(MODELS / "teapot.glb")
        program.command_line()
        program.settled_pixels()
        frames = program.frames
        # However busy the machine is, who waits is asleep, and who does not is at least ready to run.
        states = []
        for _ in range(40):
            time.sleep(0.05)
            states.append(self.state(program))
        program.command_line()
        self.assertEqual(program.frames, frames, "a picture was drawn while nothing changed")
        self.assertLess(states.count("R"), 5, "it does not sleep")
        program.close()

    @staticmethod
    def state(program: ViewerProgram) -> str:
        """Of the program's main thread: S asleep, R running or ready to."""
        return pathlib.Path(f"/proc/{program.process.pid}/stat").read_text().rsplit(")", 1)[1].split()[0]

    def test_files(self):
        own = self.folder / "own.glb"
        shutil.copy(MODELS / "sphere.glb", own)
        program = self.start(own, MODELS / "torus.glb")
        program.expect_equal_pixels("first file")
        program.draw_key("Right")
        program.expect_equal_pixels("second file")
        self.assertTrue(program.command_line()[-1].endswith("torus.glb"))
        program.draw_key("Right")
        self.assertTrue(program.command_line()[-1].endswith("own.glb"))
        program.draw_key("Up")
        replacement = self.folder / "new.part"
        shutil.copy(MODELS / "t_junction.glb", replacement)
        replacement.rename(own)
        program.wait_for_frame()
        program.expect_equal_pixels("changed on disk")
        own.write_bytes(b"no model")
        program.wait_for_frame()  # The old model stays, with a message over it that the next key removes.
        program.key("z", "z")
        program.close()

    def test_picture_and_settings(self):
        program = self.start(MODELS / "teapot.glb", "--settings", self.write_settings())
        program.drag(1, (160, 120), (100, 100))
        program.draw_key("s")
        program.expect_equal_pixels("settings given")
        program.key("F12")
        self.assertEqual(program.wait_for_line("wrote"), "wrote teapot-1.png")
        self.assertTrue((self.folder / "teapot-1.png").exists())
        program.key("ctrl+s")
        program.wait_for_line("saved")
        words = program.command_line()
        wanted = program.rendered_hash(words)
        saved = [words[0], words[1], "--settings", "view.json", "-o", "out.png", "--", words[-1]]
        self.assertEqual(program.rendered_hash(saved), wanted)
        program.draw_key("Return")
        program.draw_key("ctrl+o")
        self.assertEqual(program.rendered_hash(program.command_line()), wanted)
        program.close()

    def write_settings(self) -> str:
        (self.folder / "view.json").write_text(
            '{"shading": "gouraud", "background": [0.1, 0.2, 0.3], "light": ["key", "point:pos=1,2,3:intensity=-0.5"],'
            ' "edges": true, "exposure": 0.25}')
        return "view.json"

    def test_split(self):
        program = self.start(MODELS / "lost_highlight.glb", "--color-management", "none")
        program.draw_key("d")
        program.draw_key("s")
        left = program.rendered_picture()
        program.key("shift+a")
        right = program.rendered_picture()
        self.assertNotEqual(left, right)
        self.expect_split(program, left, right, 160)
        program.drag(1, (160, 50), (80, 60))
        program.wait_for_frame()
        self.expect_split(program, left, right, 80)
        # The heat map is black where the two are the same, and somewhere it is not.
        program.draw_key("shift+d")
        shown = program.settled_pixels()
        same = [i for i in range(0, len(left), 4) if left[i:i + 3] == right[i:i + 3] and i // 4 // 320 > 140]
        self.assertTrue(all(shown[i:i + 3] == bytes(3) for i in same))
        self.assertIn(b"\xff\xff\xff", [shown[i:i + 3] for i in range(0, len(shown), 4)])
        program.close()

    def expect_split(self, program: ViewerProgram, left: bytes, right: bytes, column: int, top: int = 30) -> None:
        """Away from the divider with its letters, both sides show their own picture."""
        shown = program.settled_pixels()
        for row in range(top, 240):
            begin, middle, end = row * 320 * 4, (row * 320 + column) * 4, (row + 1) * 320 * 4
            self.assertEqual(shown[begin:middle - 8], left[begin:middle - 8], f"row {row}")
            self.assertEqual(shown[middle + 8:end], right[middle + 8:end], f"row {row}")

    def test_beside_osmesa(self):
        program = self.start(MODELS / "lost_highlight.glb")
        program.draw_key("q")
        words = program.command_line()
        if "--color-management" not in words:
            self.skipTest("OSMesa is missing")
        self.assertEqual(words[words.index("--color-management") + 1], "none")
        barrido = program.rendered_picture()
        shown = program.settled_pixels()
        differences = [abs(shown[i + c] - barrido[i + c]) for y in range(100, 240) for x in range(1, 319)
                       if not 150 < x < 170 for i in [(y * 320 + x) * 4] for c in range(3)]
        self.assertLess(sum(d > 1 for d in differences), len(differences) / 500)
        for key in ("s", "s", "s", "s"):
            program.draw_key(key)
        program.draw_key("q")
        program.expect_equal_pixels("Barrido alone again")
        self.assertNotIn("--color-management", program.command_line())
        self.assertEqual(program.close(), 0)

    def test_light_is_dragged(self):
        program = self.start(MODELS / "sphere.glb", "--light", "point:pos=0,0,3", "--light-markers",
                             "--camera-position", "0,0,10", "--camera-focal-point", "0,0,0")
        program.drag(1, (160, 120), (190, 100))
        words = program.command_line()
        light = words[words.index("--light") + 1]
        place = light.split("pos=")[1].split(":")[0]
        x, y, z = map(float, place.split(","))
        # 240 pixels are 2·7·tan(15°) of the plane through the light.
        unit = 2 * 7 * 0.2679492 / 240
        self.assertAlmostEqual(x, 30 * unit, 4)
        self.assertAlmostEqual(y, 20 * unit, 4)
        self.assertAlmostEqual(z, 3.0, 4)
        program.close()

    def test_a_light_of_the_file_is_dragged(self):
        program = self.start(MODELS / "room.glb", "--resolution", "450,320", "--light-markers")
        program.drag(1, (225, 67), (265, 67))
        words = program.command_line()
        self.assertNotIn("--camera-position", words)
        lights = [words[i + 1] for i, word in enumerate(words) if word == "--light"]
        places = [list(map(float, light.split("pos=")[1].split(":")[0].split(","))) for light in lights]
        self.assertEqual(places[1], [0.0, 0.15, 1.2])
        self.assertGreater(places[0][0], 0.1)
        self.assertAlmostEqual(places[0][1], 1.8, 4)
        program.draw_key("x")  # The handles are not in the picture.
        program.expect_equal_pixels("a light of the file, moved")
        program.close()

    def test_no_display(self):
        environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        result = subprocess.run([PROGRAMS / "barrido-view", MODELS / "teapot.glb"], env=environment,
                                capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^barrido-view: no window can be opened: .*DISPLAY.*\n$")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[3:]])
