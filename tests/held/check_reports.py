"""Figures of `barrido diff`, `--stats` and `inspect` against values that are reckoned apart, from pictures and scenes made here.

usage: check_reports.py BARRIDO [PART...]      parts: diff costs inspect mirror
"""

import pathlib
import subprocess
import sys
import tempfile
from collections.abc import Callable

import report_costs
import report_diff
import report_inspect
import report_mirror

PARTS = {"diff": report_diff.check, "costs": report_costs.check, "inspect": report_inspect.check, "mirror": report_mirror.check}


class Program:
    """The program, run in a folder."""

    def __init__(self, path: str, folder: pathlib.Path) -> None:
        self._path, self.folder = path, folder

    def __call__(self, *words: str) -> tuple[int, bytes, bytes]:
        result = subprocess.run([self._path, *words], cwd=self.folder, capture_output=True, check=False)
        return result.returncode, result.stdout, result.stderr


def run(name: str, check: Callable, path: str) -> list[str]:
    with tempfile.TemporaryDirectory(prefix="barrido-held-") as folder:
        lines: list[str] = []
        count = check(Program(path, pathlib.Path(folder)), lines)
    print(f"{name}: {count} figures, {len(lines)} differ")
    return [f"{name}: {line}" for line in lines]


def main() -> int:
    path = str(pathlib.Path(sys.argv[1]).resolve())
    lines = [line for name in sys.argv[2:] or PARTS for line in run(name, PARTS[name], path)]
    print("\n".join(lines[:25]))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
