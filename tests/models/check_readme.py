"""Checks that models/README.md lists every model and picture of models/ with its SHA-256.

usage: check_readme.py [--update] MODELS_FOLDER     (--update writes the hashes of the files into the table)
"""

import hashlib
import pathlib
import re
import sys


# | `file` | … | `hash` |
ROW = re.compile(r"^(\| `([^`]+)` \|.*\| `)([0-9a-f]{64}|-)(` \|)$", re.MULTILINE)


def hashes(folder: pathlib.Path) -> dict[str, str]:
    """File name (relative to the folder) to SHA-256, of all models and pictures."""
    files = (p for p in folder.rglob("*") if p.suffix in {".glb", ".png"})
    return {p.relative_to(folder).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}


def differences(actual: dict[str, str], listed: dict[str, str]) -> list[str]:
    missing = [f"{name}: not in README.md" for name in sorted(actual.keys() - listed.keys())]
    gone = [f"{name}: in README.md, but there is no such file" for name in sorted(listed.keys() - actual.keys())]
    wrong = [
        f"{name}: README.md says {listed[name]}, the file has {actual[name]}"
        for name in sorted(actual.keys() & listed.keys())
        if actual[name] != listed[name]
    ]
    return missing + gone + wrong


def main() -> int:
    folder = pathlib.Path(sys.argv[-1])
    readme = folder / "README.md"
    text = readme.read_text(encoding="utf-8")
    actual = hashes(folder)
    if "--update" in sys.argv:
        text = ROW.sub(lambda row: row[1] + actual.get(row[2], row[3]) + row[4], text)
        readme.write_text(text, encoding="utf-8")
    problems = differences(actual, {row[2]: row[3] for row in ROW.finditer(text)})
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
