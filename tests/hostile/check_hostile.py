"""Tries the program on broken files that are made for the purpose, and on those of ../shared/assets/hostile if they are there.

usage: check_hostile.py PROGRAM PART [--all] [--case TEXT] [--sanitized]

PART is models, files, pictures, compressed, scale, sweep or assets. --all: the whole sweep instead of a part; --case: only cases whose names hold
TEXT, told one by one; --sanitized: without limits on memory, which sanitizers need.
"""

import argparse
import importlib
import os
import pathlib
import sys

from calls import Case, run_case
from sweep import sweep

EVERY = 9  # Of the sweep's files, without --all.
ASSETS = pathlib.Path(__file__).resolve().parents[2].parent / "shared/assets/hostile"
EXPECTATIONS = {"ERROR": "error", "SAFE": "fine", "EITHER": "either"}


# Their only fault is a picture, which is left out with a warning.
PICTURES = ("87_image", "89_image", "91_image", "92_image")


def assets() -> list[Case]:
    """The files of the manifest, each read from a folder of its own."""
    rows = [line.split("\t") for line in (ASSETS / "MANIFEST.tsv").read_text().splitlines()[1:]]
    return [Case(f"asset {row[0]}", {row[0]: (ASSETS / row[0]).read_bytes()},
                 ["render", row[0], "-o", "out.png", "--resolution", "64,64"], "fine" if row[0].startswith(PICTURES) else EXPECTATIONS[row[2]]) for row in rows]


def cases_of(part: str) -> list[Case]:
    return assets() if part == "assets" else list(importlib.import_module(f"cases_{part}").all_cases())


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("part")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--case", default="")
    parser.add_argument("--sanitized", action="store_true")
    words = parser.parse_args()
    if words.part == "assets" and not ASSETS.is_dir():
        print("../shared/assets/hostile is not there: skipped")
        return 77
    if words.part == "sweep":
        count, problems = sweep(words.program, 1 if words.all else EVERY, words.sanitized)
    else:
        cases = [case for case in cases_of(words.part) if words.case in case.name]
        count = len(cases)
        problems = []
        for case in cases:
            problem = run_case(words.program, case, words.sanitized)
            if words.case:
                print(case.name, "-", problem or "fine")
            problems += [problem] if problem else []
    print("\n".join(problems[:50]))
    print(f"{count} files tried, {len(problems)} complaints")
    return 1 if problems or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
