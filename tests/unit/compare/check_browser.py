"""The HTML report in a browser: the slider parts the pictures, blinking swaps them, the lens tells the values, keys do what
they promise, nothing is fetched and nothing goes wrong, in light and dark; by the colours of pixels on the screen.

usage: check_browser.py BARRIDO [SCREENSHOT.png]
"""

import pathlib
import sys
import tempfile

import checks
import png
from browser import Browser

RED, BLUE, WHITE = (200, 30, 30), (30, 30, 200), (255, 255, 255)
WORST = (40, 20)
MANY = 120


def make_pictures(folder: pathlib.Path) -> None:
    for side in ("a", "b"):
        (folder / side / "many").mkdir(parents=True)
    png.write(folder / "a/x.png", 64, 48, 3, lambda x, y, c: RED[c])
    png.write(folder / "b/x.png", 64, 48, 3, lambda x, y, c: WHITE[c] if (x, y) == WORST else BLUE[c])
    png.write(folder / "a/size.png", 40, 40, 3, lambda x, y, c: RED[c])
    png.write(folder / "b/size.png", 20, 30, 3, lambda x, y, c: RED[c])
    png.write(folder / "b/new.png", 20, 30, 3, lambda x, y, c: BLUE[c])
    for i in range(MANY):
        png.write(folder / f"a/many/{i:03}.png", 6, 4, 3, lambda x, y, c: 100)
        png.write(folder / f"b/many/{i:03}.png", 6, 4, 3, lambda x, y, c, v=100 + i % 2: v)


class Report:
    def __init__(self, browser: Browser, check: checks.Checks):
        self.browser, self.check = browser, check

    def text(self, selector: str) -> str:
        return self.browser.value(f"document.querySelector(`{selector}`).textContent")

    def expect_color(self, what: str, x: float, y: float, expected) -> None:
        self.check.equal(self.browser.color_at(".stage", x, y), expected, what)

    def choose(self, name: str) -> None:
        self.browser.value(
            f"[...document.querySelectorAll('tr[data-pair]')].find(r => r.cells[0].textContent.startsWith('{name}')).click()"
        )
        self.browser.wait_for(f"document.querySelector('#name').textContent === '{name}'")


def check_table(report: Report) -> None:
    browser, check = report.browser, report.check
    names = browser.value("[...document.querySelectorAll('tr[data-pair] td:first-child')].map(c => c.firstChild.textContent)")
    check.equal(names[:2], ["size.png", "x.png"], "worst first")
    check.equal(len(names), MANY + 3, "rows")
    check.equal(report.text("h1"), f"{MANY // 2 + 3} of {MANY + 3} pairs failed", "title")
    check.expect(browser.value("document.querySelectorAll('canvas').length") < 20, "pictures are made before they are looked at")


def check_slider(report: Report) -> None:
    browser = report.browser
    browser.press("2")
    report.expect_color("slider, left", 0.25, 0.25, RED)
    report.expect_color("slider, right", 0.75, 0.25, BLUE)
    browser.value("document.querySelector('.handle').focus()")
    for _ in range(3):
        browser.press("ArrowRight", shift=True)
    report.expect_color("slider moved right by keys", 0.75, 0.25, RED)
    report.expect_color("slider moved right by keys, beyond", 0.9, 0.25, BLUE)
    browser.drag(".handle", (0.5, 0.5), ".stage", (0.1, 0.5))
    report.expect_color("slider dragged left", 0.25, 0.25, BLUE)
    report.expect_color("slider dragged left, before", 0.05, 0.25, RED)
    report.check.equal(browser.value("document.querySelector('.handle').getAttribute('aria-valuenow')"), "10", "slider's value")
    browser.value("document.activeElement.blur()")


def check_blink(report: Report) -> None:
    browser = report.browser
    browser.press("3")
    for key, color, name in (("", RED, "expected"), ("b", BLUE, "actual"), ("b", RED, "expected"), (" ", BLUE, "actual")):
        if key:
            browser.press(key)
        report.expect_color(f"blink after '{key}'", 0.25, 0.25, color)
        report.check.equal(report.text("#shown"), name, "blink's label")
    browser.press("a")
    browser.wait_for("document.querySelector('#shown').textContent === 'expected'")
    browser.wait_for("document.querySelector('#shown').textContent === 'actual'")
    browser.press("a")
    browser.press("4")
    report.expect_color("difference times 1", 0.25, 0.25, (170, 0, 170))
    browser.press("5")
    report.check.expect(sum(browser.color_at(".stage", 0.25, 0.25)) > 300, "FLIP of red and blue is dark")


def check_lens(report: Report) -> None:
    browser, check = report.browser, report.check

    def values(kind: str) -> list[str]:
        return browser.value(f"[...document.querySelectorAll('.values tr[data-kind={kind}] td')].map(c => c.textContent)")

    browser.press("3")
    browser.press("w")
    check.equal(report.text("#spot"), "(40, 20)", "the lens is on the worst pixel")
    check.equal(values("expected"), ["200", "30", "30", "255"], "values expected")
    check.equal(values("actual"), ["255", "255", "255", "255"], "values found")
    check.expect(int(report.text("#zoom").split()[0]) >= 800, "not zoomed to the worst pixel")
    report.expect_color("the worst pixel on the screen", 40.5 / 64, 20.5 / 48, WHITE)
    browser.press("ArrowLeft")
    browser.press("ArrowDown", shift=True)
    check.equal(report.text("#spot"), "(39, 30)", "the lens after arrows")
    check.equal(values("actual"), ["30", "30", "200", "255"], "values after arrows")
    browser.press("0")
    browser.point(".stage", 10.5 / 64, 5.5 / 48)
    check.equal(report.text("#spot"), "(10, 5)", "the lens follows the pointer")


def check_pairs(report: Report) -> None:
    browser, check = report.browser, report.check
    browser.press("1")
    browser.press("k")
    browser.wait_for("document.querySelector('#name').textContent === 'size.png'")
    check.equal(report.text(".note"), "size 40 x 40 expected, 20 x 30 found", "note")
    check.equal(browser.value("document.querySelectorAll('.gallery figure').length"), 4, "pictures of a pair of different sizes")
    browser.press("j")
    browser.wait_for("document.querySelector('#name').textContent === 'x.png'")
    report.choose("new.png")
    check.equal(browser.value("document.querySelectorAll('.gallery figure').length"), 1, "pictures of a new file")
    check.equal(browser.value("document.querySelector('button[data-mode=slider]').hidden"), True, "slider for one picture")
    report.choose("many/000.png")
    check.expect("Nothing differs" in report.text(".empty"), "what is the same has no pictures")
    browser.click(".filters button[data-outcome=different]")
    check.equal(browser.value("document.querySelectorAll('tr[data-pair]:not([hidden])').length"), MANY // 2 + 2, "rows filtered")
    browser.click(".filters button[data-outcome=different]")
    report.choose("x.png")


def check_light_and_dark(report: Report) -> None:
    for scheme, is_right in (("light", lambda c: min(c) > 200), ("dark", lambda c: max(c) < 60)):
        report.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        color = report.browser.color_at("header", 0.9, 0.2)
        report.check.expect(is_right(color), f"{scheme}: the header is {color}")


def check_events(report: Report, url: str) -> None:
    for event in report.browser.events:
        method, parameters = event.get("method"), event.get("params", {})
        if method == "Network.requestWillBeSent":
            report.check.expect(parameters["request"]["url"].startswith((url, "blob:")), f"fetched: {parameters['request']['url']}")
        bad = method == "Runtime.exceptionThrown" or (method == "Log.entryAdded" and parameters["entry"]["level"] == "error")
        report.check.expect(not bad, f"{method}: {parameters}")


def main() -> int:
    checks.need("chromium", "chromium")
    check = checks.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_pictures(folder)
        check.equal(checks.Barrido(sys.argv[1], folder).diff("a", "b", "--html", "report").returncode, 1, "exit status")
        url = (folder / "report/index.html").as_uri()
        with Browser("chromium", 1400, 900) as browser:
            browser.open(url + "#x.png")
            browser.wait_for("document.querySelector('#name')?.textContent === 'x.png'")
            report = Report(browser, check)
            for part in (check_table, check_slider, check_blink, check_lens, check_pairs, check_light_and_dark):
                part(report)
            if len(sys.argv) > 2:
                pathlib.Path(sys.argv[2]).write_bytes(browser.screenshot())
            check_events(report, url)
    return check.end()


if __name__ == "__main__":
    sys.exit(main())
