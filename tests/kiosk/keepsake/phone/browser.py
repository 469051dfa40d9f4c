"""Debian's chromium, led by its own protocol (Chrome DevTools) over two pipes: no driver, no package of another world
between the test and the browser.

    with Browser() as browser:
        page = browser.page(width=360, height=740)
        page.go("http://127.0.0.1:8080/k/...")
        page.value("document.title")
"""
import base64
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time

PROGRAMS = ("/usr/lib/chromium/chromium", "chromium")
PATIENCE = 30.0  # s

# What is cut off, lies outside, or stands out too little from what is behind it (WCAG 2.1, AA: 4.5 to 1).
LAYOUT = """(() => {
  const found = [], wide = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > wide) found.push("the page scrolls sideways");
  const parts = (c) => c.match(/[\\d.]+/g).map(Number);
  const behind = (e) => {
    for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor); if (c[3] !== 0) return c; }
    return [255, 255, 255];
  };
  const light = (c) => {
    const [r, g, b] = c.slice(0, 3).map((v) => (v /= 255) <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  let words = 0;
  for (const e of document.querySelectorAll("body *")) {
    if (!e.checkVisibility()) continue;
    const box = e.getBoundingClientRect(), name = e.tagName + " " + e.textContent.slice(0, 30);
    if (box.left < -0.5 || box.right > wide + 0.5) found.push(name + " lies outside");
    if (e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0 && getComputedStyle(e).overflowX !== "auto") found.push(name + " is cut off");
    if (![...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim())) continue;
    ++words;
    const a = light(parts(getComputedStyle(e).color)), b = light(behind(e));
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) found.push(name + " stands out by " + contrast.toFixed(2) + " only");
    if (/^(A|SUMMARY|BUTTON)$/.test(e.tagName) && box.height < 44) found.push(name + " is too low for a finger");
  }
  return { found, words };
})()"""


def program():
    """Where the browser is; None where there is none."""
    return next((found for found in map(shutil.which, PROGRAMS) if found), None)


class Browser:
    """A chromium without a window and with a profile of its own, gone with the object."""

    def __init__(self):
        self.profile = tempfile.mkdtemp(prefix="onggi-browser-")
        to_it, ours = os.pipe()
        theirs, from_it = os.pipe()
        # It reads 3 and writes 4. Both ends are moved out of the way of those numbers first.
        held = [os.dup(to_it), os.dup(from_it)]
        far = [os.open(os.devnull, os.O_RDONLY) for _ in range(8)]

        def hand_over():
            os.dup2(held[0], 63), os.dup2(held[1], 62)
            os.dup2(63, 3), os.dup2(62, 4)

        self.process = subprocess.Popen(
            [program(), "--headless=new", "--remote-debugging-pipe", f"--user-data-dir={self.profile}", "--no-sandbox",
             "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--disable-extensions", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
             "--disable-dev-shm-usage", "--lang=en-US"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, close_fds=False,
            preexec_fn=hand_over, env={**os.environ, "HOME": self.profile})
        for end in (to_it, from_it, *held, *far):
            os.close(end)
        self.pipe_in, self.pipe_out, self.rest, self.number = theirs, ours, b"", 0
        self.answers, self.events = {}, []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.pipe_out)
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.pipe_in)
        shutil.rmtree(self.profile, ignore_errors=True)

    def say(self, method, session=None, **params):
        """Says `method` and gives the answer."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        os.write(self.pipe_out, json.dumps(message).encode() + b"\0")
        number = self.number
        self.until(lambda: number in self.answers, method)
        answer = self.answers.pop(number)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def until(self, done, what, patience=PATIENCE):
        """Hears the browser until `done()`."""
        end = time.monotonic() + patience
        while not done():
            left = end - time.monotonic()
            if left <= 0:
                raise TimeoutError(f"the browser took more than {patience:.0f} s: {what}")
            self.hear(min(left, 0.05))

    def hear(self, patience):
        if not select.select([self.pipe_in], [], [], patience)[0]:
            return
        got = os.read(self.pipe_in, 1 << 20)
        if not got:
            raise RuntimeError("the browser ended")
        *whole, self.rest = (self.rest + got).split(b"\0")
        for text in whole:
            message = json.loads(text)
            if "id" in message:
                self.answers[message["id"]] = message
            else:
                self.events.append(message)

    def page(self, width, height, **kept):
        return Page(self, width, height, **kept)


class Page:
    """A page as one phone shows it: nothing is shared with other pages."""

    def __init__(self, browser, width, height, dark=False, languages="en", still=True, scale=2, before=None):
        self.browser = browser
        self.context = browser.say("Target.createBrowserContext")["browserContextId"]
        target = browser.say("Target.createTarget", url="about:blank", browserContextId=self.context)["targetId"]
        self.session = browser.say("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Network", "Runtime", "Log", "Audits"):
            self.say(domain + ".enable")
        self.say("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=True)
        self.say("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        self.say("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
            {"name": "prefers-reduced-motion", "value": "reduce" if still else "no-preference"}])
        self.say("Network.setExtraHTTPHeaders", headers={"Accept-Language": languages})
        if before:
            self.say("Page.addScriptToEvaluateOnNewDocument", source=before)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.say("Target.disposeBrowserContext", browserContextId=self.context)

    def say(self, method, **params):
        return self.browser.say(method, self.session, **params)

    def events(self, method):
        return [e["params"] for e in self.browser.events
                if e["method"] == method and e.get("sessionId") == self.session]

    def arriving(self, act, what):
        """`act`, after which another document is shown, whole."""
        before = len(self.events("Page.loadEventFired"))
        act()
        self.browser.until(lambda: len(self.events("Page.loadEventFired")) > before, what)

    def go(self, address):
        self.arriving(lambda: self.say("Page.navigate", url=address), address)

    def value(self, script):
        """What `script` comes to; a promise is waited for."""
        got = self.say("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in got:
            raise RuntimeError(f"{script}: {got['exceptionDetails']}")
        return got["result"].get("value")

    def wait(self, script, what=None, patience=PATIENCE):
        self.browser.until(lambda: self.value(script), what or script, patience)

    def middle(self, selector):
        """Scrolls it into view and gives its middle."""
        return self.value(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
            e.scrollIntoView({{block: "center", behavior: "instant"}}); const r = e.getBoundingClientRect();
            return [r.x + r.width / 2, r.y + r.height / 2]; }})()""")

    def tap(self, selector):
        x, y = self.middle(selector)
        self.fingers("touchStart", [(x, y)])
        self.fingers("touchEnd", [])

    def fingers(self, kind, places):
        self.say("Input.dispatchTouchEvent", type=kind,
                 touchPoints=[{"x": x, "y": y, "id": n} for n, (x, y) in enumerate(places)])

    def picture(self, path, whole=True):
        got = self.say("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        pathlib.Path(path).write_bytes(base64.b64decode(got["data"]))

    def asked(self):
        """Every address that was asked for."""
        return [e["request"]["url"] for e in self.events("Network.requestWillBeSent")]

    def complaints(self):
        """Errors and warnings of the console, scripts that failed, and what the page's policy forbade."""
        return ([str(e["args"]) for e in self.events("Runtime.consoleAPICalled") if e["type"] in ("error", "warning")] +
                [str(e["exceptionDetails"]) for e in self.events("Runtime.exceptionThrown")] +
                [e["entry"]["text"] for e in self.events("Log.entryAdded")
                 if e["entry"]["level"] in ("error", "warning")] +
                [str(e["issue"]) for e in self.events("Audits.issueAdded")
                 if e["issue"]["code"] == "ContentSecurityPolicyIssue"])
