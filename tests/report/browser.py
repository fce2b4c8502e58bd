"""A headless Chromium, driven over its DevTools protocol."""

import base64
import json
import shutil
import subprocess
import tempfile
import time
import urllib.request
from pathlib import Path

import websocket

FLAGS = [
    "--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--hide-scrollbars",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--remote-debugging-port=0", "--remote-allow-origins=*", "--force-device-scale-factor=1",
]  # fmt: skip


def chromium():
    return shutil.which("chromium")


class Browser:
    """One page in a browser of its own; `requests` has the address of everything it asked for."""

    def __init__(self, width=1400, height=1000):
        self.profile = tempfile.mkdtemp(prefix="suture-browser-")
        self.process = subprocess.Popen(
            [chromium(), *FLAGS, f"--user-data-dir={self.profile}", f"--window-size={width},{height}",
             "about:blank"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        port = self._wait_for_port()
        pages = json.load(urllib.request.urlopen(f"http://127.0.0.1:{port}/json/list", timeout=20))
        target = next(page for page in pages if page["type"] == "page")
        self.socket = websocket.create_connection(target["webSocketDebuggerUrl"], timeout=400)
        self.last = 0
        self.requests, self.errors = [], []
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.send(f"{domain}.enable")
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)

    def _wait_for_port(self):
        file = Path(self.profile) / "DevToolsActivePort"
        for _ in range(600):
            if file.exists() and (lines := file.read_text().split()):
                return int(lines[0])
            if self.process.poll() is not None:
                raise RuntimeError(f"chromium ended with {self.process.returncode}")
            time.sleep(0.05)
        raise RuntimeError("chromium does not answer")

    def close(self):
        try:
            self.send("Browser.close")
        except Exception:  # it may be gone already
            self.process.kill()
        self.socket.close()
        try:
            self.process.wait(timeout=30)
        except subprocess.TimeoutExpired:  # the newest one does not always end
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def send(self, method, **parameters):
        self.last += 1
        self.socket.send(json.dumps({"id": self.last, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.recv())
            self._note(message)
            if message.get("id") == self.last:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]

    def _note(self, message):
        parameters = message.get("params", {})
        if message.get("method") == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])
        elif message.get("method") == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description") or details["text"])
        elif message.get("method") == "Log.entryAdded" and parameters["entry"]["level"] == "error":
            self.errors.append(parameters["entry"]["text"])

    def open(self, file, fragment="", limit=60):
        """Opens a file from disk; seconds until its script had drawn the first picture."""
        begun = time.monotonic()
        self.send("Page.navigate", url=Path(file).as_uri() + fragment)
        while time.monotonic() - begun < limit:
            if self.value("document.readyState === 'complete' && document.documentElement.dataset.ready"):
                return time.monotonic() - begun
            time.sleep(0.02)
        raise RuntimeError(f"{file} was not ready after {limit} s: {self.errors}")

    def wait_for(self, expression, limit=60):
        """Until it is true, also in a page that is not there yet."""
        begun = time.monotonic()
        while time.monotonic() - begun < limit:
            try:
                if self.value(f"Boolean({expression})"):
                    return
            except RuntimeError:
                pass  # between two pages
            time.sleep(0.02)
        raise RuntimeError(f"{expression} was not true after {limit} s: {self.errors}")

    def count_cpu_seconds(self):
        self.send("Performance.enable", timeDomain="threadTicks")

    def cpu_seconds(self):
        """Of the page's main thread, since its process began."""
        metrics = self.send("Performance.getMetrics")["metrics"]
        return next(m["value"] for m in metrics if m["name"] == "TaskDuration")

    def value(self, expression):
        result = self.send("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"]["exception"]["description"])
        return result["result"].get("value")

    def settle(self):
        """Until animations have ended and the last picture is drawn."""
        self.value("new Promise(done => setTimeout(() => requestAnimationFrame("
                   "() => requestAnimationFrame(done)), 400))")

    def click(self, x, y, modifiers=0):
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1,
                      modifiers=modifiers)
        self.settle()

    def click_on(self, selector):
        box = self.value(f"(() => {{ const e = document.querySelector({json.dumps(selector)});"
                         "e.scrollIntoView({block: 'nearest'});"
                         "const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()")
        self.click(*box)

    def key(self, key, modifiers=0):
        text = {"text": key} if len(key) == 1 else {}
        codes = {"ArrowDown": 40, "ArrowUp": 38, "Escape": 27, "End": 35, "Home": 36}
        for kind in ("keyDown", "keyUp"):
            self.send("Input.dispatchKeyEvent", type=kind, key=key, modifiers=modifiers,
                      windowsVirtualKeyCode=codes.get(key, 0), **(text if kind == "keyDown" else {}))
        self.settle()

    def screenshot(self, file=None):
        data = base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"])
        if file:
            Path(file).write_bytes(data)
        return data

    def differing_pixels(self, action):
        """The part of the 3D view's pixels that an action changes."""
        self.value(
            "(() => { const c = document.getElementById('view'); const copy = document.createElement('canvas');"
            "copy.width = c.width; copy.height = c.height; const pen = copy.getContext('2d');"
            "window.pixels = () => { pen.drawImage(c, 0, 0); return pen.getImageData(0, 0, c.width, c.height).data; };"
            "window.first = window.pixels(); })()"
        )
        action()
        self.settle()
        return self.value(
            "(() => { const a = window.first, b = window.pixels(); let n = 0;"
            "for (let i = 0; i < a.length; i += 4) if (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1])"
            "+ Math.abs(a[i + 2] - b[i + 2]) > 60) ++n; return 4 * n / a.length; })()"
        )
