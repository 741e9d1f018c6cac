"""Runs the program on files from strangers and tells what it did wrong: anything but a picture and exit status 0, or one
line and exit status 2; too much memory; files left behind."""

import dataclasses
import os
import pathlib
import resource
import subprocess
import tempfile
import threading
from collections.abc import Callable

MOST_MEMORY_KB = 608 * 1024  # The 464 MiB of docs/limits.md, a processor's share, a frame, and twice a file of some MB.
MOST_ADDRESSES = 4 << 30  # More than what is resident: threads reserve what they never use.
HANGS_AFTER_S = 120  # Generous, since the machine may be busy: nothing here takes more than a few seconds.
LONGEST_LINE = 1000


@dataclasses.dataclass
class Case:
    """One call in a folder of its own that holds `files`."""

    name: str
    files: dict[str, bytes]
    words: list[str]
    expect: str = "either"  # fine, error, warned (drawn, with a warning), told (warned or an error) or either
    says: str = ""  # Part of the line of an error or a warning
    prepare: Callable[[pathlib.Path], None] | None = None  # For what is no plain file
    writes: str = "out.png"  # What is there afterwards if all is fine; empty: nothing
    fine: tuple[int, ...] = (0,)


@dataclasses.dataclass
class Answer:
    status: int  # Negative: the number of a signal
    lines: list[str]
    memory_kb: int


def call(program: str, words: list[str], folder: pathlib.Path, sanitized: bool = False) -> Answer:
    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if not sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))

    with tempfile.TemporaryFile() as errors:
        # Waited for by hand, since only wait4 tells what this one child needed.
        child = subprocess.Popen([program, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 stderr=errors, preexec_fn=limit)
        guard = threading.Timer(HANGS_AFTER_S, child.kill)
        guard.start()
        _, status, usage = os.wait4(child.pid, 0)
        guard.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        text = errors.read().decode(errors="replace")
    return Answer(child.returncode, text.splitlines(), usage.ru_maxrss)


def all_files(folder: pathlib.Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


def line_problem(line: str) -> str:
    """What is wrong with a line of an error; empty when nothing is."""
    if not line.startswith("barrido: "):
        return "does not begin with the program's name"
    if len(line) > LONGEST_LINE:
        return f"has {len(line)} characters"
    return "holds control characters" if any(ord(letter) < 32 for letter in line) else ""


def problem_of(case: Case, answer: Answer, before: set[str], folder: pathlib.Path, sanitized: bool) -> str:
    if answer.status not in (*case.fine, 2):
        return f"status {answer.status}"
    if not sanitized and answer.memory_kb > MOST_MEMORY_KB:
        return f"{answer.memory_kb} KB"
    left = all_files(folder) - before
    if answer.status != 2:
        if case.expect == "error":
            return "no error"
        if case.expect in ("warned", "told") and not any(case.says in line for line in answer.lines):
            return f"no warning that says '{case.says}'"
        missing = case.writes and case.writes not in left
        return f"{case.writes} is missing" if missing else ""
    if case.expect in ("fine", "warned"):
        return "an error"
    errors = [line for line in answer.lines if not line.startswith("barrido: warning: ")]
    if len(errors) != 1:
        return f"{len(errors)} lines"
    if case.says not in errors[0]:
        return f"does not say '{case.says}'"
    return line_problem(errors[0]) or (f"left {sorted(left)}" if left else "")


def run_case(program: str, case: Case, sanitized: bool = False) -> str:
    """The complaint; empty when all is well. `sanitized`: the program needs much memory of its own."""
    with tempfile.TemporaryDirectory(prefix="barrido-hostile-") as name:
        folder = pathlib.Path(name)
        for file, data in case.files.items():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_bytes(data)
        if case.prepare:
            case.prepare(folder)
        before = all_files(folder)
        answer = call(program, case.words, folder, sanitized)
        problem = problem_of(case, answer, before, folder, sanitized)
    return f"{case.name}: {problem} (status {answer.status}): {' | '.join(answer.lines[:3])[:400]}" if problem else ""
