#!/usr/bin/env python3
"""Renders the frames of frames.txt with every instruction set and several numbers of threads, and compares the SHA-256 of
their pixels with the committed hashes.txt.

usage: check_hashes.py BARRIDO [--bless] [--threads 1,2,4] [--simd scalar,sse4,…]

--bless writes hashes.txt anew, after checking that all ways agree with each other. Run it with a build of another
compiler or optimisation level to prove that the pixels are the same there.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
HASHES = HERE / "hashes.txt"


def frames():
    for line in (HERE / "frames.txt").read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            name, *arguments = line.split()
            yield name, arguments


def run(barrido, arguments):
    command = [barrido, "render", *arguments, "--resolution", "200,150", "--quiet"]
    return subprocess.run(command, cwd=PROJECT, capture_output=True, text=True, check=False)


def available(barrido, names):
    """The instruction sets of this program and processor, found by asking for each."""
    first = next(frames())[1]
    return [name for name in names if run(barrido, [*first, "--hash", "--simd", name]).returncode == 0]


def hash_of(barrido, arguments, simd, threads):
    result = run(barrido, [*arguments, "--hash", "--simd", simd, "--threads", str(threads)])
    if result.returncode != 0:
        return f"exit status {result.returncode}: {result.stderr.strip()}"
    return result.stdout.split()[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barrido")
    parser.add_argument("--bless", action="store_true")
    parser.add_argument("--threads", default="1,2,4")
    parser.add_argument("--simd", default="scalar,sse4,avx2,avx512,neon")
    options = parser.parse_args()
    barrido = str(pathlib.Path(options.barrido).resolve())

    targets = available(barrido, options.simd.split(","))
    if not targets:
        sys.exit(f"{barrido} renders with none of {options.simd}")
    ways = [(simd, int(threads)) for simd in targets for threads in options.threads.split(",")]
    jobs = [(name, arguments, simd, threads) for name, arguments in frames() for simd, threads in ways]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda job: hash_of(barrido, *job[1:]), jobs))

    expected = {}
    if not options.bless:
        expected = dict(reversed(line.split()) for line in HASHES.read_text().splitlines())
    failures = []
    for (name, _, simd, threads), found in zip(jobs, results):
        wanted = expected.setdefault(name, found) if options.bless else expected.get(name, "no hash")
        if found != wanted or " " in found:
            failures.append(f"{name} ({simd}, {threads} threads): {found}, expected {wanted}")
    for failure in failures:
        print(failure, file=sys.stderr)
    if options.bless and not failures:
        HASHES.write_text("".join(f"{expected[name]}  {name}\n" for name, _ in frames()))
    print(f"{len(jobs)} renderings of {len(list(frames()))} frames with {', '.join(targets)}: {len(failures)} differ")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
