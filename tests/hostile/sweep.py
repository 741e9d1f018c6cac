"""Every value of a document in turn replaced by values that do not belong there."""

import json
import pathlib
import tempfile
from collections.abc import Iterator

from calls import MOST_MEMORY_KB, call, line_problem
from models import everything

# As JSON text, since Python would not write some of them.
VALUES = ["-1", "0", "1", "0.5", "-0.0", "255", "65536", "2147483647", "2147483648", "4294967295", "9007199254740992",
          "18446744073709551615", "18446744073709551616", "1e30", "-1e30", "1e308", "-1e308", "1e999", "null", "true", '""', '"x"',
          '"\\u0000"', "[]", "{}", "[[[]]]", "[1e308,1e308,1e308,1e308]", "[0,0,0]"]
MARK = "?mark?"
A_CALL = 64  # Files in one call of the program: it tells of each that is refused and goes on.


def places(value, path: tuple = ()) -> Iterator[tuple]:
    """The paths of all values but the root."""
    if path:
        yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in items:
        yield from places(child, (*path, key))


def replaced(document: dict, path: tuple, text: str) -> bytes:
    changed = json.loads(json.dumps(document))
    parent = changed
    for key in path[:-1]:
        parent = parent[key]
    parent[path[-1]] = MARK
    return json.dumps(changed).replace(f'"{MARK}"', text).encode()


def documents(every: int) -> Iterator[tuple[str, bytes]]:
    """Every `every`th of the changed documents with its name."""
    document = everything().with_buffer()
    number = 0
    for path in places(document):
        for value, text in enumerate(VALUES):
            number += 1
            if number % every == 0:
                yield f"{number}-" + "_".join(map(str, path)) + f"-{value}", replaced(document, path, text)


def batch_problems(program: str, batch: list[tuple[str, bytes]], sanitized: bool, words: list[str]) -> list[str]:
    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        folder = pathlib.Path(name)
        for file, data in batch:
            (folder / f"{file}.gltf").write_bytes(data)
        files = [f"{file}.gltf" for file, _ in batch]
        answer = call(program, ["render", *files, "-o", "{model}.png", "--quiet", *words], folder, sanitized)
        pictures = {path.stem for path in folder.glob("*.png")}
        others = [path.name for path in folder.iterdir() if path.suffix not in (".png", ".gltf")]
        texts = dict(batch)
        if answer.status not in (0, 2):
            if len(batch) == 1:
                return [f"{batch[0][0]}: status {answer.status}: {answer.lines[:2]}: {batch[0][1][:3000]!r}"]
            return [problem for one in batch for problem in batch_problems(program, [one], sanitized, words)]
    problems = [f"left {name}" for name in others] + [f"{line}: {line_problem(line)}" for line in answer.lines if line_problem(line)]
    if not sanitized and answer.memory_kb > MOST_MEMORY_KB:
        problems.append(f"{answer.memory_kb} KB for {batch[0][0]} to {batch[-1][0]}")
    for file in texts:
        told = sum(line.startswith(f"barrido: {file}.gltf: ") for line in answer.lines)
        if told + (file in pictures) != 1:
            problems.append(f"{file}: {told} lines and {'a' if file in pictures else 'no'} picture: {answer.lines[:2]}")
    return problems


def sweep(program: str, every: int, sanitized: bool) -> tuple[int, list[str]]:
    """@return how many files were tried, and the complaints."""
    changed = list(documents(every))
    problems = []
    for begin in range(0, len(changed), A_CALL):
        # A moment within the animation; cameras of both kinds.
        words = ["--resolution", "16,16", "--time", "0.25"] + (["--camera-index", "none"] if begin // A_CALL % 2 else [])
        problems += batch_problems(program, changed[begin:begin + A_CALL], sanitized, words)
    return len(changed), problems
