"""Runs every `barrido …` line that README.md shows, as a reader would paste it, and checks that all of them work; and
that the source it quotes from examples/triangle stands there.

usage: check_commands.py BARRIDO PROJECT_FOLDER
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

COMMAND = re.compile(r"^    (barrido .+)$", re.MULTILINE)
CPP_BLOCK = re.compile(r"^```cpp\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def failures_of_commands(readme: str, barrido: pathlib.Path, project: pathlib.Path) -> list[str]:
    failures = []
    commands = COMMAND.findall(readme)
    if not commands:
        return ["README.md shows no command"]
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(project / "models", pathlib.Path(folder) / "models")
        os.symlink(barrido, pathlib.Path(folder) / "barrido")
        environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
        for command in commands:
            result = subprocess.run(
                command, shell=True, cwd=folder, env=environment, capture_output=True, text=True, check=False
            )
            if result.returncode != 0 or "warning" in result.stderr:
                failures.append(f"{command}\n  exit status {result.returncode}: {result.stderr.strip()}")
    return failures


def failures_of_quotes(readme: str, project: pathlib.Path) -> list[str]:
    """Lines of the quoted example that the example does not hold; comments and indentation do not count."""
    def code_lines(text: str) -> set[str]:
        lines = (re.sub(r"\s*//.*", "", line).strip() for line in text.splitlines())
        return {line for line in lines if line}

    example = code_lines((project / "examples/triangle/main.cpp").read_text(encoding="utf-8"))
    quoted = code_lines("".join(CPP_BLOCK.findall(readme)))
    return [f"not in examples/triangle/main.cpp: {line}" for line in sorted(quoted - example)]


def main() -> int:
    barrido = pathlib.Path(sys.argv[1]).resolve()
    project = pathlib.Path(sys.argv[2]).resolve()
    readme = (project / "README.md").read_text(encoding="utf-8")
    failures = failures_of_commands(readme, barrido, project) + failures_of_quotes(readme, project)
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
