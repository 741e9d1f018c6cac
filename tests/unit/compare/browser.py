"""A headless Chromium, driven through its DevTools protocol over a pair of pipes: no network, nothing but Python's library."""

import base64
import json
import os
import subprocess
import tempfile
import time

import png

PATIENCE_S = 60  # A busy machine is no failure.
POINTER_DOWN = {"button": "left", "buttons": 1, "clickCount": 1}


class Browser:
    def __init__(self, program: str, width: int, height: int):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        commands, self.commands = os.pipe()
        self.answers, answers = os.pipe()
        # The browser reads commands from descriptor 3 and writes answers to 4.
        words = [
            program, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
            "--disable-dev-shm-usage", "--force-color-profile=srgb", "--force-device-scale-factor=1",
            f"--user-data-dir={self.profile.name}", f"--window-size={width},{height}", "--remote-debugging-pipe",
        ]
        self.process = subprocess.Popen(
            ["/bin/sh", "-c", f'exec "$@" 3<&{commands} 4>&{answers}', "sh", *words],
            pass_fds=(commands, answers), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        os.close(commands)
        os.close(answers)
        self.buffer, self.count, self.session, self.events = b"", 0, None, []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.profile.cleanup()

    def call(self, method: str, **parameters) -> dict:
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") != self.count:
                self.events.append(answer)
            elif "error" in answer:
                raise RuntimeError(f"{method}: {answer['error']}")
            else:
                return answer["result"]

    def receive(self) -> dict:
        while b"\0" not in self.buffer:
            data = os.read(self.answers, 1 << 20)
            if not data:
                raise RuntimeError("the browser has ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def open(self, url: str) -> None:
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Page.navigate", url=url)

    def value(self, expression: str):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def wait_for(self, expression: str) -> None:
        end = time.monotonic() + PATIENCE_S
        while not self.value(expression):
            if time.monotonic() > end:
                raise RuntimeError(f"never became true: {expression}")
            time.sleep(0.05)

    def press(self, key: str, shift: bool = False) -> None:
        text = key if len(key) == 1 else ""
        modifiers = 8 if shift else 0
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=text, modifiers=modifiers)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, modifiers=modifiers)

    def place(self, selector: str, x: float, y: float) -> dict:
        """Where on the page the fraction (x, y) of an element is."""
        box = self.value(f"(r => [r.x, r.y, r.width, r.height])(document.querySelector(`{selector}`).getBoundingClientRect())")
        return {"x": box[0] + x * box[2], "y": box[1] + y * box[3]}

    def point(self, selector: str, x: float, y: float) -> None:
        self.call("Input.dispatchMouseEvent", type="mouseMoved", **self.place(selector, x, y))

    def drag(self, selector: str, begin, box: str, end) -> None:
        self.call("Input.dispatchMouseEvent", type="mousePressed", **POINTER_DOWN, **self.place(selector, *begin))
        self.call("Input.dispatchMouseEvent", type="mouseMoved", **POINTER_DOWN, **self.place(box, *end))
        self.call("Input.dispatchMouseEvent", type="mouseReleased", **POINTER_DOWN, **self.place(box, *end))

    def click(self, selector: str) -> None:
        self.value(f"document.querySelector(`{selector}`).click()")

    def screenshot(self, **clip) -> bytes:
        parameters = {"clip": {**clip, "scale": 1}} if clip else {}
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", **parameters)["data"])

    def color_at(self, selector: str, x: float, y: float) -> tuple:
        """What is on the screen there."""
        place = self.place(selector, x, y)
        _, _, pixel = png.read(self.screenshot(x=int(place["x"]), y=int(place["y"]), width=2, height=2))
        return pixel(0, 0)
