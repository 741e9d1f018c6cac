"""What the checks of `barrido diff` share: running it, and being skipped where another program is missing."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77


def need(program: str, package: str) -> None:
    """Skips the whole check where `program` is missing; where everything should be installed, that is a failure."""
    if shutil.which(program) is None:
        print(f"skipped: there is no {program} here (Debian: {package})")
        sys.exit(1 if os.environ.get("CI") == "true" else SKIPPED)


class Barrido:
    def __init__(self, program: str, folder: pathlib.Path):
        self.program, self.folder = pathlib.Path(program).resolve(), folder

    def diff(self, *words: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            [self.program, "diff", *words], cwd=self.folder, capture_output=True, text=True, errors="replace", check=False
        )

    def pairs(self, *words: str) -> list[dict]:
        return json.loads(self.diff(*words, "--json", "-").stdout)["pairs"]


class Checks:
    """Collects what does not hold, so that one run tells all of it."""

    def __init__(self):
        self.failures = []

    def expect(self, holds: bool, message: str) -> None:
        if not holds:
            self.failures.append(message)

    def equal(self, found, expected, what: str) -> None:
        self.expect(found == expected, f"{what}: {found!r}, expected {expected!r}")

    def end(self) -> int:
        for failure in self.failures:
            print(failure)
        return 1 if self.failures else 0
