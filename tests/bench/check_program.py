#!/usr/bin/env python3
"""Runs barrido-bench on two cheap workloads and a piece, reads its JSON, and checks its messages for options that make no
sense. Asserts no time.

usage: check_program.py BARRIDO-BENCH
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)


def check(condition, what, process):
    if not condition:
        sys.exit(f"{what}\nstatus {process.returncode}\n{process.stdout}{process.stderr}")


def check_report(program, folder):
    file = folder / "report.json"
    process = run(program, "--only", "W1,W10", "--resolution", "64,36", "--seconds", 0, "--json", file)
    check(process.returncode == 0, "a run failed", process)
    report = json.loads(file.read_text(encoding="utf-8"))
    check([row["id"] for row in report["workloads"]] == ["W1", "W10"], "the JSON has other workloads", process)
    check(all(row["barrido_ms"] > 0 for row in report["workloads"]), "a time is missing", process)
    check(report["machine"]["resolution"] == [64, 36], "the JSON tells another resolution", process)
    for row in report["workloads"]:
        if "osmesa_ms" in row:
            check(row["difference"]["largest_of_255"] <= 1, f"{row['id']} is drawn otherwise by OSMesa", process)
    check([entry.name for entry in folder.iterdir()] == ["report.json"], "something is left beside the JSON", process)


def check_messages(program, folder):
    for arguments, expected in ((("--only", "W99"), "W99"), (("--simd", "mmx"), "mmx"), (("--scaling", "size"), "size"),
                                (("--json", folder / "none" / "x.json"), "x.json"), (("--resolution", "0,5"), "0")):
        process = run(program, *arguments)
        check(process.returncode == 2 and expected in process.stderr, f"no good message for {arguments}", process)


def check_pieces(program):
    process = run(program, "--pieces", "--benchmark_filter=png_decode|assembly|texture_filter/nearest$",
                  "--benchmark_min_time=0.001")
    check(process.returncode == 0, "the pieces failed", process)
    for piece in ("png_decode", "assembly_and_binning", "texture_filter/nearest"):
        check(piece in process.stdout, f"no piece {piece}", process)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        check_report(program, Path(folder))
        check_messages(program, Path(folder))
    check_pieces(program)


if __name__ == "__main__":
    main()
