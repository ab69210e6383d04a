"""A headless Chromium that draws WebGPU in software, driven through its debugging pipe.

Messages are JSON texts that end with a zero byte; see the Chrome DevTools Protocol.
"""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

# With fewer of them WebGPU works, but the canvas is missing in screenshots.
SOFTWARE_WEBGPU = [
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--ignore-gpu-blocklist",
]

QUIET = [
    "--headless=new",
    "--no-sandbox",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-dev-shm-usage",
    "--disable-extensions",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
]

# Windows' codes of keys that have no letter.
KEY_CODES = {
    "F2": 113,
    "Tab": 9,
    "Escape": 27,
    "Insert": 45,
    "Backslash": 220,
    "Quote": 222,
    "Space": 32,
    "PageDown": 34,
    "ArrowRight": 39,
    "ArrowDown": 40,
}
# What those keys type.
KEY_TEXTS = {"Backslash": "\\", "Quote": "'", "Space": " "}


class Chromium:
    """One browser with one page."""

    def __init__(self, size=(960, 540), downloads=None):
        self.profile = tempfile.mkdtemp(prefix="lightfall-chromium-")
        to_browser, self.commands = os.pipe()
        self.answers, from_browser = os.pipe()

        def connect():
            # Chromium reads from 3 and writes to 4, whatever numbers the pipes had.
            ends = os.dup(to_browser), os.dup(from_browser)
            for number, end in zip((3, 4), ends):
                os.dup2(end, number)

        arguments = [f"--window-size={size[0]},{size[1]}", f"--user-data-dir={self.profile}"]
        self.process = subprocess.Popen(
            ["chromium", "--remote-debugging-pipe", *QUIET, *SOFTWARE_WEBGPU, *arguments, "about:blank"],
            preexec_fn=connect,
            close_fds=False,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.number = 0
        self.replies = {}
        # What the console said, and what went wrong on the page.
        self.console = []
        self.faults = []
        # Where scripts run, by the origin of the page or of a page in it.
        self.contexts = {}
        target = self.call("Target.createTarget", url="about:blank", session=None)["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True, session=None)["sessionId"]
        for domain in ("Runtime", "Page", "Log"):
            self.call(domain + ".enable")
        self.resize(size)
        if downloads:
            self.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(downloads), session=None)

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        for end in (self.commands, self.answers):
            os.close(end)
        shutil.rmtree(self.profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    session = None

    def call(self, method, session="page", **parameters):
        """Sends a command and waits for its result."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.commands, data) :]
        end = time.monotonic() + 120
        while self.number not in self.replies:
            if time.monotonic() > end:
                raise TimeoutError(f"{method}: no reply")
            self.listen(1)
        reply = self.replies.pop(self.number)
        if "error" in reply:
            raise RuntimeError(f"{method}: {reply['error']['message']}")
        return reply["result"]

    def listen(self, seconds):
        """Takes in what the browser says, for this long at most."""
        ready, _, _ = select.select([self.answers], [], [], seconds)
        if not ready:
            return
        data = os.read(self.answers, 1 << 20)
        if not data:
            raise RuntimeError(f"Chromium has ended with status {self.process.poll()}")
        self.buffer += data
        *messages, self.buffer = self.buffer.split(b"\0")
        for message in messages:
            self.take(json.loads(message))

    def take(self, message):
        if "id" in message:
            self.replies[message["id"]] = message
            return
        parameters = message["params"]
        if message["method"] == "Runtime.consoleAPICalled":
            words = (str(part.get("value", part.get("description", ""))) for part in parameters["args"])
            text = " ".join(words)
            self.console.append(text)
            if parameters["type"] == "error" or "panicked" in text or "ERROR" in text:
                self.faults.append(text)
        elif message["method"] == "Log.entryAdded":
            # What the browser itself says, such as that WebGPU refuses a command.
            entry = parameters["entry"]
            self.console.append(entry["text"])
            if entry["level"] in ("warning", "error"):
                self.faults.append(entry["text"])
        elif message["method"] == "Runtime.executionContextCreated":
            context = parameters["context"]
            self.contexts[context["origin"]] = context["id"]
        elif message["method"] == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            text = details.get("exception", {}).get("description", details["text"])
            # The window system leaves the start of the program by an exception that is no fault.
            if "Using exceptions for control flow" not in text:
                self.faults.append(text)

    def open(self, address):
        self.call("Page.navigate", url=address)

    def before_pages(self, script):
        """Runs a script on every page before the page's own."""
        self.call("Page.addScriptToEvaluateOnNewDocument", source=script)

    def evaluate(self, expression, origin=None):
        """The value of an expression on the page or, where an origin is named, on the page from there in it."""
        context = {"contextId": self.contexts.get(origin, -1)} if origin else {}
        result = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True, **context)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']['text']}")
        return result["result"].get("value")

    def wait_until(self, expression, seconds, origin=None):
        """Waits until an expression is true. Returns whether it became so."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                if self.evaluate(expression, origin):
                    return True
            except RuntimeError:
                # The page has no contents yet.
                pass
            self.listen(0.1)
        return False

    def wait(self, seconds):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            self.listen(left)

    def resize(self, size):
        self.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False)

    def press(self, code):
        """Presses the key with this code, such as KeyH, and lets it go."""
        name = code.removeprefix("Key").lower() if code.startswith("Key") else code
        virtual = KEY_CODES.get(code, ord(code[-1]))
        key = {"code": code, "key": KEY_TEXTS.get(code, name), "windowsVirtualKeyCode": virtual}
        # Space scrolls a page by what it types.
        kind = {"type": "keyDown", "text": " "} if code == "Space" else {"type": "rawKeyDown"}
        self.call("Input.dispatchKeyEvent", **kind, **key)
        self.wait(0.2)
        self.call("Input.dispatchKeyEvent", type="keyUp", **key)

    def drag(self, start, way, button="right"):
        """Drags the mouse with a button held."""
        mouse = {"button": button, "buttons": 2 if button == "right" else 1, "clickCount": 1}
        self.move(start)
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], **mouse)
        steps = 8
        for step in range(1, steps + 1):
            x, y = (s + w * step / steps for s, w in zip(start, way))
            self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y, **mouse)
            self.wait(0.2)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=x, y=y, **{**mouse, "buttons": 0})

    def click(self, place, button="left"):
        """Clicks slowly enough for a program that draws in software."""
        self.move(place)
        mouse = {"button": button, "clickCount": 1, "x": place[0], "y": place[1]}
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, **mouse)
            self.wait(0.4)

    def move(self, place):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=place[0], y=place[1])

    def wheel(self, place, down):
        """Turns the wheel by so many pixels."""
        self.call("Input.dispatchMouseEvent", type="mouseWheel", x=place[0], y=place[1], deltaX=0, deltaY=down)

    def touch(self, *ways):
        """Puts fingers down, moves each through its places, and lifts them."""

        def send(kind, points):
            points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(points)]
            self.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
            self.wait(0.3)

        for number, places in enumerate(zip(*ways)):
            send("touchMove" if number else "touchStart", places)
        send("touchEnd", ())

    def screenshot(self, file):
        data = self.call("Page.captureScreenshot", format="png")["data"]
        file.write_bytes(base64.b64decode(data))
        return file
