"""The style check finds what it is there to find, and nothing in clean files."""

import pathlib
import tempfile
import unittest

import check_style


class CheckStyle(unittest.TestCase):
    def findings(self, path: str, text: str) -> list[str]:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / path
            file.parent.mkdir(parents=True)
            file.write_text(text, encoding="utf-8")
            return check_style.check(pathlib.Path(folder))

    def test_includes_that_point_down_are_fine(self):
        self.assertEqual(self.findings("viewer/a.cpp", '#include "pipeline/scene/scene.h"\n#include <vector>\n'), [])
        self.assertEqual(self.findings("pipeline/scene/a.cpp", '#include "pipeline/state.h"\n'), [])
        self.assertEqual(self.findings("pipeline/gltf/a.cpp", "#include <tiny_gltf.h>\n"), [])

    def test_includes_that_point_up_are_found(self):
        for path, header in [
            ("raster/a.h", "pipeline/state.h"),
            ("raster/kernels/a.cpp", "viewer/barrido/arguments.h"),
            ("raster/textures/a.h", "raster/tiles/tile.h"),
            ("raster/kernels/a.h", "raster/rasterizer.h"),
            ("pipeline/a.cpp", "pipeline/scene/scene.h"),
            ("pipeline/pictures/a.cpp", "pipeline/scene/scene.h"),
            ("pipeline/scene/a.cpp", "pipeline/gltf/import_gltf.h"),
            ("pipeline/scene/a.cpp", "viewer/barrido/arguments.h"),
            ("raster/a.cpp", "tests/unit/helper.h"),
        ]:
            self.assertEqual(len(self.findings(path, f'#include "{header}"\n')), 1, path)

    def test_private_headers_are_found(self):
        self.assertEqual(len(self.findings("viewer/a.cpp", "#include <tiny_gltf.h>\n")), 1)
        self.assertEqual(len(self.findings("pipeline/a.cpp", "#include <OpenImageIO/imageio.h>\n")), 1)
        self.assertEqual(len(self.findings("viewer/barrido/a.cpp", "#include <GLFW/glfw3.h>\n")), 1)

    def test_long_files_and_open_work_are_found(self):
        self.assertEqual(self.findings("raster/a.cpp", "\n" * 400), [])
        self.assertEqual(len(self.findings("raster/a.cpp", "\n" * 401)), 1)
        self.assertEqual(len(self.findings("raster/a.cpp", "// TO" + "DO: later\n")), 1)


if __name__ == "__main__":
    unittest.main()
