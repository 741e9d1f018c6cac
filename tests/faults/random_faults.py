"""Plants random faults, one at a time, in copies of the project that are built beside each other, and runs the tests of the module
and then all others until one turns red."""

import dataclasses
import hashlib
import os
import pathlib
import re
import resource
import shutil
import subprocess
import threading
import time
from collections.abc import Callable, Iterator

from mutations import Mutation

# The tests that look at a folder first; the others follow in the order of TESTS.
FIRST = {
    "pipeline/gltf": ["held.scenes", "barrido_scene_tests"], "pipeline/scene": ["held.scenes", "barrido_scene_tests"],
    "pipeline/validate": ["barrido_validate_tests"], "pipeline/inspect": ["held.reports", "barrido_inspect_tests"],
    "pipeline/files": ["barrido_scene_tests"], "pipeline/pictures": ["barrido_scene_tests"], "pipeline": ["pipeline_test"],
    "viewer/compare": ["held.reports", "compare_unit_test", "diff_program_test"],
    "viewer/barrido": ["held.scenes", "held.reports", "viewer_unit_test", "viewer_program_test"],
    "viewer/sheet": ["barrido_scene_tests"], "viewer": ["view_unit_test"], "raster": ["unit_raster", "kernels"],
}
# Programs of tests, and tests that ctest knows by name, with what must be built for them.
TESTS = {
    "held.scenes": ["dump_scene"], "held.reports": ["barrido"], "golden.pictures": ["barrido", "barrido-golden"],
    "pipeline_test": [], "barrido_scene_tests": [], "barrido_inspect_tests": [], "viewer_unit_test": [], "compare_unit_test": [],
    "diff_program_test": [], "viewer_program_test": [], "view_unit_test": [], "barrido_validate_tests": [], "unit_raster": [],
    "kernels": [], "oracle_test": [], "same_bits.hashes": ["barrido"], "osmesa.crosscheck": ["barrido-crosscheck"],
    "readme.commands": ["barrido"], "hostile": ["barrido"], "fuzz_corpus_test": [],
}
MOST_MEMORY = 6 << 30
FEWER_SCENES = {"BARRIDO_HELD_SCENES": "200"}  # One fault shows in many.
MOST_DEPENDENTS = 30  # A header that more objects include is left out: each fault would build everything.
# One instruction set beside the portable one, where kernels are to be compiled over and over.
LIGHT = ["-D", "CMAKE_BUILD_TYPE=None", "-D", "CMAKE_CXX_FLAGS=-O1",
         "-D", "BARRIDO_DISABLED_SIMD=(HWY_SSSE3|HWY_AVX2|HWY_AVX3|HWY_AVX3_DL)"]


@dataclasses.dataclass
class Outcome:
    mutation: Mutation
    killed_by: str  # Empty: it survived.
    seconds: float


class CannotRun(Exception):
    """The project does not build, or its tests are red, without any fault."""


class Workshop:
    """A copy of the project with a build folder of its own."""

    def __init__(self, folder: pathlib.Path, light: bool, tests: list[str]) -> None:
        self.tree = folder / "tree"
        self.build = self.tree / "build" / ("light" if light else "release")
        self._light, self._tests = light, tests
        self._limits: dict[str, float] = {}
        self._objects: dict[str, bytes] = {}

    def prepare(self) -> None:
        """Builds, and runs all tests once: they must be green, and tell how long they take."""
        launcher = ["-D", "CMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        options = LIGHT if self._light else ["-D", "CMAKE_BUILD_TYPE=Release"]
        self._must(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", *options, "-D", "BARRIDO_TEST_OPTIONS=-O0", *launcher])
        self._must(["ninja", "-C", self.build, *self._targets(self._tests)])
        for name in self._tests:
            begin = time.monotonic()
            if self._red(name, 3600):
                raise CannotRun(f"{name} is red without any fault")
            self._limits[name] = 60 + 10 * (time.monotonic() - begin)
        for path in self.build.rglob("*.o"):
            self._objects[path.relative_to(self.build).as_posix()] = digest(path)

    def try_out(self, mutation: Mutation) -> Outcome | None:
        """Nothing where the fault does not compile, or its object code is what it was."""
        path = self.tree / mutation.file
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines(keepends=True)
        lines[mutation.line - 1] = mutation.new + "\n"
        begin = time.monotonic()
        path.write_text("".join(lines), encoding="utf-8")
        try:
            if not self._compiles_to_something_else(mutation.file):
                return None
            return Outcome(mutation, self._first_red(mutation.file), time.monotonic() - begin)
        finally:
            path.write_text(text, encoding="utf-8")

    def _compiles_to_something_else(self, file: str) -> bool:
        objects = [name for name in self._dependents(file) if name in self._objects]
        if not objects or len(objects) > MOST_DEPENDENTS:
            return False
        # That of the file itself first: most faults that do not compile are told by it.
        objects.sort(key=lambda name: pathlib.Path(file).stem not in name)
        changed = False
        for name in objects:
            if run(["ninja", "-C", self.build, name], 1800).returncode:
                return False
            changed = changed or digest(self.build / name) != self._objects[name]
            if changed:
                return True
        return False

    def _dependents(self, file: str) -> list[str]:
        """The objects of which the file is a part, as the last build found them."""
        if not hasattr(self, "_by_file"):
            self._by_file: dict[str, list[str]] = {}
            current = ""
            for line in run(["ninja", "-C", self.build, "-t", "deps"], 600).stdout.splitlines():
                if line.startswith(" "):
                    included = os.path.normpath(self.build / line.strip())
                    self._by_file.setdefault(included, []).append(current)
                elif ": #deps" in line:
                    current = line.split(": #deps")[0]
        return list(self._by_file.get(os.path.normpath(self.tree / file), []))

    def _first_red(self, file: str) -> str:
        first = FIRST[max((folder for folder in FIRST if file.startswith(folder + "/")), key=len)]
        order = [name for name in first if name in self._tests] + [name for name in self._tests if name not in first]
        for name in order:
            if run(["ninja", "-C", self.build, *self._targets([name])], 1800).returncode:
                return "a part that no longer builds"
            reason = self._red(name, self._limits[name])
            if reason:
                return reason
        return ""

    def _targets(self, tests: list[str]) -> list[str]:
        return sorted({target for name in tests for target in (TESTS[name] or [name])})

    def _red(self, name: str, limit: float) -> str:
        """What turned red, or nothing."""
        if TESTS[name]:
            words = ["ctest", "--test-dir", str(self.build), "--stop-on-failure", "-R", f"^{re.escape(name)}"]
        else:
            program = next(path for path in self.build.rglob(name) if path.is_file() and os.access(path, os.X_OK))
            words = [str(program), "--gtest_fail_fast", "--gtest_brief=1"]
        try:
            result = run(words, limit, self.tree)
        except subprocess.TimeoutExpired:
            return f"{name}, which does not end"
        if result.returncode == 0:
            return ""
        failed = re.search(r"\[  FAILED  \] (\S+)", result.stdout)
        return f"{name}: {failed.group(1).rstrip(',')}" if failed else name

    def _must(self, words: list) -> None:
        result = run(words, 7200)
        if result.returncode:
            raise CannotRun(f"{' '.join(map(str, words[:4]))}: {result.stdout[-2000:]}{result.stderr[-2000:]}")


def digest(path: pathlib.Path) -> bytes:
    return hashlib.sha256(path.read_bytes()).digest()


def limit_memory() -> None:
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEMORY, MOST_MEMORY))


def run(words: list, limit: float, folder: pathlib.Path | None = None) -> subprocess.CompletedProcess:
    """Ends all that it started when the time is over."""
    with subprocess.Popen([str(word) for word in words], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          errors="replace", env={**os.environ, **FEWER_SCENES}, start_new_session=True, preexec_fn=limit_memory) as child:
        try:
            out, err = child.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, 9)
            child.communicate()
            raise
    return subprocess.CompletedProcess(words, child.returncode, out, err)


class Run:
    """`count` faults that change what is compiled, tried out by all workshops in turn."""

    def __init__(self, workshops: list[Workshop], mutations: list[Mutation], count: int, tell: Callable[[str], None]) -> None:
        self._workshops, self._mutations, self._count, self._tell = workshops, iter(mutations), count, tell
        self._lock = threading.Lock()
        self.outcomes: list[Outcome] = []
        self.tried = 0
        self.error = ""

    def run(self) -> None:
        threads = [threading.Thread(target=self._work, args=(workshop,)) for workshop in self._workshops]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def _next(self) -> Iterator[Mutation]:
        while True:
            with self._lock:
                mutation = next(self._mutations, None)
                if mutation is None or len(self.outcomes) >= self._count or self.error:
                    return
                self.tried += 1
            yield mutation

    def _work(self, workshop: Workshop) -> None:
        try:
            workshop.prepare()
        except CannotRun as error:
            self.error = str(error)
            return
        for mutation in self._next():
            outcome = workshop.try_out(mutation)
            if outcome is None:
                continue
            with self._lock:
                if len(self.outcomes) >= self._count:
                    return
                self.outcomes.append(outcome)
                self._tell(f"{len(self.outcomes)}. {outcome.mutation}: {outcome.killed_by or 'SURVIVES'} ({outcome.seconds:.0f} s)")
