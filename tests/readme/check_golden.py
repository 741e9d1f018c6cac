"""Runs the golden-image test that README.md shows, as its readers would: blessed, passed, failed, blessed again.

usage: check_golden.py BARRIDO PROJECT_FOLDER
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

SCRIPT = re.compile(r"As `golden.sh`:\n\n```sh\n(.*?)^```$", re.MULTILINE | re.DOTALL)
MODELS = ("teapot", "torus", "showcase")


class Reader:
    """Somebody with models of their own who follows the README in `folder`."""

    def __init__(self, folder: pathlib.Path, barrido: pathlib.Path, project: pathlib.Path):
        self.folder, self.failures = folder, []
        readme = (project / "README.md").read_text(encoding="utf-8")
        (folder / "golden.sh").write_text(SCRIPT.search(readme)[1], encoding="utf-8")
        (folder / "bin").mkdir()
        os.symlink(barrido, folder / "bin/barrido")
        (folder / "models").mkdir()
        for name in MODELS:
            shutil.copy(project / f"models/{name}.glb", folder / "models")
        self.environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}

    def run(self, what: str, words: list[str], status: int) -> None:
        result = subprocess.run(
            ["sh", "golden.sh", *words], cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False
        )
        if result.returncode != status:
            output = result.stdout + result.stderr
            self.failures.append(f"{what}: exit status {result.returncode}, expected {status}\n{output}")

    def expect(self, holds: bool, message: str) -> None:
        if not holds:
            self.failures.append(message)

    def failed_tests(self) -> list[str]:
        cases = ElementTree.parse(self.folder / "report.xml").getroot().iter("testcase")
        return sorted(case.get("name") for case in cases if len(case))


def follow(reader: Reader) -> None:
    folder = reader.folder
    reader.run("without golden pictures", [], 1)
    reader.run("the first time", ["--bless"], 0)
    reader.expect(sorted(p.stem for p in (folder / "golden").iterdir()) == sorted(MODELS), "not all models are blessed")
    reader.run("nothing changed", [], 0)
    reader.expect(reader.failed_tests() == [], "tests fail though nothing changed")

    shutil.copy(folder / "models/torus.glb", folder / "models/teapot.glb")
    (folder / "models/showcase.glb").unlink()
    reader.run("a model changed, another went", [], 1)
    reader.expect(reader.failed_tests() == ["showcase.png", "teapot.png"], f"failed: {reader.failed_tests()}")
    reader.expect("2 of 3 pairs failed" in (folder / "report/index.html").read_text(encoding="utf-8"), "no such report")

    (folder / "models/broken.glb").write_bytes(b"glTF of a kind")
    reader.run("a new model is broken", [], 2)
    reader.expect("showcase.png" in reader.failed_tests(), "no report beside a broken model")
    (folder / "golden/showcase.png").unlink()
    reader.run("only the broken model is wrong", ["--bless"], 2)
    (folder / "models/broken.glb").unlink()
    reader.run("the change is wanted", ["--bless"], 0)
    reader.run("after that", [], 0)


def main() -> int:
    with tempfile.TemporaryDirectory() as name:
        reader = Reader(pathlib.Path(name), pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
        follow(reader)
    for failure in reader.failures:
        print(failure)
    return 1 if reader.failures else 0


if __name__ == "__main__":
    sys.exit(main())
