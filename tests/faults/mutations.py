"""Single changes of C++ source: operators, comparisons, constants, indices, min and max, signs, the order of arguments, a line left
out. Text is looked at line by line, without comments and strings; what does not compile afterwards is no fault."""

import dataclasses
import pathlib
import random
import re
from collections.abc import Iterator


@dataclasses.dataclass(frozen=True)
class Mutation:
    """`line` (from 1) of `file` becomes `new`."""

    file: str
    line: int
    old: str
    new: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.old.strip()} → {self.new.strip() or '(left out)'}"


# What is found, and what it becomes: text, or some of which one is chosen.
SWAPS: list[tuple[str, list[str]]] = [
    (r" \+ ", [" - "]), (r" - ", [" + "]), (r" \* ", [" / "]), (r" / ", [" * "]), (r" % ", [" / "]),
    (r" \+= ", [" -= ", " = "]), (r" -= ", [" += "]), (r" \*= ", [" /= "]),
    (r" < ", [" <= ", " > "]), (r" > ", [" >= ", " < "]), (r" <= ", [" < ", " >= "]), (r" >= ", [" > ", " <= "]),
    (r" == ", [" != "]), (r" != ", [" == "]), (r" && ", [" || "]), (r" \|\| ", [" && "]),
    (r"(?<=[( ])!(?=[\w(])", [""]), (r"(?<=[(,=] )-(?=[\w(])", [""]), (r"(?<=\()-(?=[\w(])", [""]), (r"(?<=return )-(?=[\w(])", [""]),
    (r"\bstd::min\b", ["std::max"]), (r"\bstd::max\b", ["std::min"]), (r"\bglm::min\b", ["glm::max"]), (r"\bglm::max\b", ["glm::min"]),
    (r"\bstd::floor\b", ["std::ceil"]), (r"\bstd::ceil\b", ["std::floor"]), (r"\bportable_cos\b", ["portable_sin"]),
    (r"\bportable_sin\b", ["portable_cos"]), (r"\btrue\b", ["false"]), (r"\bfalse\b", ["true"]),
    (r"\+\+", ["--"]), (r"--(?=\w)", ["++"]), (r"\.begin\(\)", [".end()"]),
    (r"(?<=\w)\.x\b", [".y"]), (r"(?<=\w)\.y\b", [".z", ".x"]), (r"(?<=\w)\.z\b", [".y"]), (r"(?<=\w)\.w\b", [".x"]),
    (r"(?<=\w)\.r\b", [".g"]), (r"(?<=\w)\.g\b", [".b"]), (r"(?<=\w)\.b\b", [".g"]), (r"\bfront\b(?=\()", ["back"]),
    (r"\bcontinue;", ["break;"]), (r"<<", [">>"]), (r"\bwidth\b", ["height"]), (r"\bheight\b", ["width"]),
]
NUMBER = re.compile(r"(?<![\w.\"'])(\d+\.\d*(?:e-?\d+)?f?|\d+)(?![\w.\"'])")
ARGUMENTS = re.compile(r"(?<=\w\()([\w.\[\]]+), ([\w.\[\]]+)(?=[,)])")
STATEMENT = re.compile(r"^\s+(?!return\b|using\b|const\b|static\b|case\b|default\b|break\b|typedef\b|namespace\b|template\b|auto\b|throw\b)"
                       r"(?:if \(.*\) .*|[\w.:\->\[\]()*]+ (?:[-+*/|]?=) .*|[\w.:\->\[\]]+\(.*\)|\+\+\w.*|--\w.*);$")
SKIPPED = re.compile(r"^\s*(#|using |template|static_assert|namespace|//|\[\[|EXPECT|friend )|assert\(")


def bare(line: str) -> str:
    """The line with comments, strings and characters blanked, so that places stay."""

    def blank(match: re.Match) -> str:
        return " " * len(match.group(0))

    line = re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])+\'', lambda m: '"' + "_" * (len(m.group(0)) - 2) + '"', line)
    return re.sub(r"//.*$|/\*.*?\*/", blank, line)


def changed_number(text: str) -> list[str]:
    """Whole numbers by one; others by a half."""
    if text.isdigit():
        return [str(int(text) + 1)] + ([str(int(text) - 1)] if int(text) > 0 else [])
    value, suffix = float(text.rstrip("f")), "f" if text.endswith("f") else ""
    return [repr(value * 1.5 if value else 1.0) + suffix]


def changes_of(line: str) -> Iterator[str]:
    """All lines that a single change makes of this one."""
    seen = bare(line)
    if SKIPPED.search(seen) or not seen.strip():
        return
    for pattern, replacements in SWAPS:
        for match in re.finditer(pattern, seen):
            for replacement in replacements:
                yield line[:match.start()] + replacement + line[match.end():]
    for match in NUMBER.finditer(seen):
        for replacement in changed_number(match.group(0)):
            yield line[:match.start()] + replacement + line[match.end():]
    for match in ARGUMENTS.finditer(seen):
        if match.group(1) != match.group(2):
            yield f"{line[:match.start()]}{line[match.start(2):match.end(2)]}, {line[match.start(1):match.end(1)]}{line[match.end():]}"
    if STATEMENT.match(seen.rstrip()) and seen.count("(") == seen.count(")"):
        yield ""


def mutations_of(root: pathlib.Path, file: str) -> list[Mutation]:
    lines = (root / file).read_text(encoding="utf-8").splitlines()
    return [Mutation(file, number, line, new) for number, line in enumerate(lines, 1) for new in changes_of(line) if new != line]


def all_mutations(root: pathlib.Path, folders: list[str], without: list[str]) -> list[Mutation]:
    """Of the sources below `folders`, except those below `without`; each line's share is the same whatever can be done to it."""
    found: list[Mutation] = []
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            file = path.relative_to(root).as_posix()
            if path.suffix in (".cpp", ".h") and not any(file.startswith(other.rstrip("/") + "/") for other in without):
                found += mutations_of(root, file)
    return found


def in_random_order(mutations: list[Mutation], seed: int) -> list[Mutation]:
    """At most one of a line, so that lines with many operators do not crowd out the others."""
    order = list(mutations)
    random.Random(seed).shuffle(order)
    chosen: dict[tuple[str, int], Mutation] = {}
    for mutation in order:
        chosen.setdefault((mutation.file, mutation.line), mutation)
    return list(chosen.values())
