"""Compares what Barrido makes of random scenes with what a second implementation makes of them.

usage: check_scenes.py DUMP_SCENE [--count N] [--seed S] [--keep DIR]

Each scene is written as a GLB file and drawn by a random call. Compared are the names of the frames, their matrices and lights,
the order of the draws, and of each draw its state, its coefficients, and its vertices in eye space.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from compare_frame import Differences, compare_frame
from frames import Call, Frames, nodes_of_scene
from invalid_scenes import invalid_scenes
from random_calls import RandomCall
from random_scenes import RandomScene

COUNT = int(os.environ.get("BARRIDO_HELD_SCENES", "600"))
WORST_SHOWN = 25


def make_call(seed: int, folder: pathlib.Path) -> tuple[RandomScene, Call]:
    scene = RandomScene(seed)
    path = folder / f"s{seed}.glb"
    path.write_bytes(scene.glb.bytes())
    tree = scene.glb.tree
    cameras = [sum("camera" in tree["nodes"][node] for node in nodes_of_scene(tree, i)) for i in range(len(tree["scenes"]))]
    return scene, RandomCall(seed, str(path), tree, cameras).call


def dumped(program: str, calls: list[list[str]], folder: pathlib.Path) -> list[dict]:
    file = folder / "calls"
    file.write_text("".join(json.dumps(words) + "\n" for words in calls), encoding="utf-8")
    result = subprocess.run([program, file], capture_output=True, check=False)
    answers = [json.loads(line) for line in result.stdout.splitlines()]
    if result.returncode != 0 or len(answers) != len(calls):
        words = " ".join(calls[min(len(answers), len(calls) - 1)])
        raise RuntimeError(f"dump_scene ended with {result.returncode} at: {words}: {result.stderr[-500:]!r}")
    return answers


def compare_call(scene: RandomScene, call: Call, answer: dict, differences: Differences) -> int:
    """Returns the number of frames."""
    if "error" in answer:
        differences.add(f"refused: {answer['error']}")
        return 0
    expected = list(Frames(scene.glb, call))
    differences.expect([frame["name"] for frame in answer["frames"]] == [frame.name for frame in expected],
                       f"names: {[frame['name'] for frame in answer['frames']]}, not {[frame.name for frame in expected]}")
    for frame, theirs in zip(expected, answer["frames"], strict=False):
        differences.place = frame.name
        differences.expect(theirs["label"] == frame.label, f"label {theirs['label']}, not {frame.label}")
        compare_frame(call, frame, theirs, differences)
    return len(expected)


def check_valid(program: str, seeds: range, folder: pathlib.Path) -> list[str]:
    made = [make_call(seed, folder) for seed in seeds]
    answers = dumped(program, [call.words for _, call in made], folder)
    lines, frames = [], 0
    total = Differences()
    for seed, (scene, call), answer in zip(seeds, made, answers, strict=True):
        differences = Differences()
        frames += compare_call(scene, call, answer, differences)
        lines += [f"seed {seed}: {line}\n    {' '.join(call.words)}" for line in differences.lines[:3]]
        total.checks += differences.checks
        total.numbers += differences.numbers
        total.skipped += differences.skipped
    print(f"{len(made)} scenes, {frames} frames, {total.checks} arrays of {total.numbers} numbers compared, {total.skipped} skipped, {len(lines)} differ")
    return lines


def check_invalid(program: str, seed: int, folder: pathlib.Path) -> list[str]:
    """Scenes that must be refused, with a word on why."""
    cases = invalid_scenes(seed)
    paths = []
    for i, (data, _) in enumerate(cases):
        paths.append(folder / f"invalid{i}.glb")
        paths[-1].write_bytes(data)
    answers = dumped(program, [[str(path), "-o", "out.png"] for path in paths], folder)
    lines = [f"not refused for '{word}': {answer.get('error', 'drawn')}" for (_, word), answer in zip(cases, answers, strict=True)
             if word not in answer.get("error", "")]
    print(f"{len(cases)} scenes to be refused, {len(lines)} were not")
    return lines


def main() -> int:
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="barrido-held-") as name:
        folder = options.keep or pathlib.Path(name)
        folder.mkdir(exist_ok=True)
        lines = check_valid(options.program, range(options.seed, options.seed + options.count), folder)
        lines += check_invalid(options.program, options.seed, folder)
    print("\n".join(lines[:WORST_SHOWN]))
    return 1 if lines else 0


if __name__ == "__main__":
    np.seterr(all="raise", under="ignore")
    sys.exit(main())
