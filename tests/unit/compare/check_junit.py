"""The JUnit report is XML that a reader of XML understands, whatever files are called.

usage: check_junit.py BARRIDO
"""

import os
import pathlib
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import checks
import png

# Names as they come; the last one holds no UTF-8.
NAMES = ["plain", "a & b", "<tag attribute=\"1\">'", "]]>", "tab\tand\nline", "\x01\x1b[31m", "Bäume 木 🌳", "\udcff\udcc3("]


def main() -> int:
    check = checks.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for side, value in (("a", 10), ("b", 20)):
            os.makedirs(folder / side / "deep")
            for file in NAMES:
                png.write(folder / side / f"{file}.png", 3, 2, 3, lambda x, y, c, v=value: v)
            png.write(folder / side / "deep" / "same.png", 3, 2, 3, lambda x, y, c: 1)
        (folder / "b" / "broken.png").write_bytes(b"x")
        barrido = checks.Barrido(sys.argv[1], folder)
        result = barrido.diff("a", "b", "--junit", "report.xml")
        check.equal(result.returncode, 2, "exit status with a file that is broken")
        suites = ElementTree.parse(folder / "report.xml").getroot()
        check.equal(suites.tag, "testsuites", "root")
        suite = suites.find("testsuite")
        for element in (suites, suite):
            counts = {key: element.get(key) for key in ("tests", "failures", "errors")}
            check.equal(counts, {"tests": "10", "failures": "8", "errors": "1"}, element.tag)
        cases = {case.get("name"): case for case in suite.findall("testcase")}
        for file in NAMES[:5] + NAMES[6:7]:
            check.expect(cases.get(f"{file}.png") is not None, f"{file!r}: no test case of this name")
        failure = cases["a & b.png"].find("failure")
        check.expect("max 0.0392157 at (0, 0)" in failure.get("message"), failure.get("message"))
        check.expect("FLIP mean" in failure.text and "RMS error" in failure.text, failure.text)
        check.equal((cases["same.png"].get("classname"), len(cases["same.png"])), ("barrido.diff/deep", 0), "same.png")
        check.expect(cases["broken.png"].find("error") is not None, "broken.png is no error")
    return check.end()


if __name__ == "__main__":
    sys.exit(main())
