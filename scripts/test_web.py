"""Uses the page in a real browser: headless Chromium, driven through ChromeDriver.

scripts/test-web runs it, with the folder of the page as its first argument and the program for the desktop as its second.
Each check says what it saw; the first that fails ends it. Numbers are printed for whoever compares them.
"""

import base64
import http.server
import json
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request
import zlib

# Drawing is by software: everything takes its time.
PATIENCE = 90.0


class Refused(Exception):
    """A check that failed."""


def check(condition, sentence):
    if not condition:
        raise Refused(sentence)
    print(f"ok: {sentence}", flush=True)


class Server:
    """The folder on the loopback address, under a path of its own; what is asked for beside it is kept."""

    PREFIX = "/some/where/"

    def __init__(self, folder):
        server = self
        self.is_cut = False

        class Handler(http.server.SimpleHTTPRequestHandler):
            def translate_path(self, path):
                path = path.split("?")[0].split("#")[0]
                return str(pathlib.Path(folder) / path.removeprefix(server.PREFIX))

            def send_head(self):
                if not self.path.startswith(server.PREFIX):
                    self.send_error(404)
                    return None
                return super().send_head()

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.address = f"http://127.0.0.1:{self.server.server_port}{self.PREFIX}"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Browser:
    """A browser with one page, and a profile that is thrown away unless it is given."""

    def __init__(self, size=(1280, 800), profile=None, touch=False, arguments=()):
        self.downloads = pathlib.Path(tempfile.mkdtemp(prefix="downloads"))
        self.own = profile is None
        self.profile = pathlib.Path(profile or tempfile.mkdtemp(prefix="profile"))
        self.port = free_port()
        self.driver = subprocess.Popen(
            ["chromedriver", f"--port={self.port}", "--log-level=SEVERE"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        options = {
            "args": [
                "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-quic", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
                f"--window-size={size[0]},{size[1]}", f"--user-data-dir={self.profile}", *arguments,
            ],
            "prefs": {"download.default_directory": str(self.downloads), "download.prompt_for_download": False},
        }
        wanted = {
            "browserName": "chrome",
            "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
        }
        self.session = None
        for _ in range(100):
            try:
                made = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
                self.session = made["sessionId"]
                break
            except (ConnectionError, urllib.error.URLError):
                time.sleep(0.1)
        if self.session is None:
            raise Refused("ChromeDriver does not answer")
        width, height = size
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=touch)
        self.cdp("Emulation.setTouchEmulationEnabled", enabled=touch, maxTouchPoints=5)
        self.cdp("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(self.downloads))
        self.cdp("Network.enable")
        self.logged = []

    def ask(self, method, path, body=None):
        prefix = f"/session/{self.session}" if self.session else ""
        if path == "/session":
            prefix = ""
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{prefix}{path}", data=data, method=method)
        request.add_header("Content-Type", "application/json")
        try:
            with urllib.request.urlopen(request, timeout=300) as answer:
                return json.loads(answer.read())["value"]
        except urllib.error.HTTPError as error:
            problem = json.loads(error.read())["value"]
            raise Refused(f"{path}: {problem['error']}: {problem['message'][:300]}") from error

    def cdp(self, command, **parameters):
        return self.ask("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def js(self, script):
        return self.ask("POST", "/execute/sync", {"script": script, "args": []})

    def promise(self, script):
        """What an asynchronous script returns."""
        body = f"const done = arguments[0]; (async () => {{ {script} }})().then(done, (e) => done(`failed: ${{e}}`));"
        return self.ask("POST", "/execute/async", {"script": body, "args": []})

    def go(self, address):
        self.ask("POST", "/url", {"url": address})

    def wait(self, of_what, until, patience=PATIENCE):
        """Waits until `until` returns something, and returns that."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            found = until()
            if found:
                return found
            time.sleep(0.1)
        raise Refused(f"waited {patience:.0f} s for {of_what}")

    def start(self, address):
        """Goes to a page with the explorer, and waits until it runs."""
        separator = "&" if "?" in address.split("#")[0] else "?"
        head, mark, fragment = address.partition("#")
        self.go(f"{head}{separator}test{mark}{fragment}")
        # The same page with another fragment is not loaded anew.
        begun = "return document.documentElement.dataset.state === 'started' && !!window.explorer_test"
        self.wait("the page to start", lambda: self.js(begun))

    def nodes(self):
        return self.js("return window.explorer_test") or []

    def find(self, name=None, role=None, last=False):
        """What has this name on the screen, and this role where one is given; `None` where nothing has."""
        found = [
            node
            for node in self.nodes()
            if (name is None or re.search(name, node["name"] or node["value"] or ""))
            and (role is None or node["role"] == role)
        ]
        return found[-1 if last else 0] if found else None

    def seen(self, name, role=None):
        return self.wait(f"'{name}'", lambda: self.find(name, role))

    def mouse(self, kind, x, y, **more):
        self.cdp("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, node, at=(0.5, 0.5)):
        x, y = node["x"] + at[0] * node["width"], node["y"] + at[1] * node["height"]
        self.mouse("mouseMoved", x, y)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)
        time.sleep(0.4)

    def drag(self, begin, end, steps=8):
        (x0, y0), (x1, y1) = begin, end
        self.mouse("mouseMoved", x0, y0)
        self.mouse("mousePressed", x0, y0, button="left", clickCount=1)
        for step in range(1, steps + 1):
            part = step / steps
            self.mouse("mouseMoved", x0 + part * (x1 - x0), y0 + part * (y1 - y0), button="left", buttons=1)
            time.sleep(0.05)
        self.mouse("mouseReleased", x1, y1, button="left", clickCount=1)
        time.sleep(0.5)

    def touch(self, begin, end, steps=8):
        (x0, y0), (x1, y1) = begin, end
        self.cdp("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x0, "y": y0}])
        for step in range(1, steps + 1):
            part = step / steps
            point = {"x": x0 + part * (x1 - x0), "y": y0 + part * (y1 - y0)}
            self.cdp("Input.dispatchTouchEvent", type="touchMove", touchPoints=[point])
            time.sleep(0.05)
        self.cdp("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        time.sleep(0.5)

    def key(self, key, modifiers=0, text=None):
        code = f"Key{key.upper()}" if len(key) == 1 and key.isalpha() else key
        codes = {"Enter": 13, "Tab": 9, "Escape": 27, "Backspace": 8, ".": 190, ",": 188, "-": 189}
        number = codes.get(key, ord(key.upper()) if len(key) == 1 else 0)
        event = {"key": key, "code": code, "modifiers": modifiers, "windowsVirtualKeyCode": number}
        if text is not None:
            event["text"] = text
        self.cdp("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", **event)
        self.cdp("Input.dispatchKeyEvent", type="keyUp", **event)
        time.sleep(0.08)

    def type(self, text):
        for letter in text:
            self.key(letter, text=letter)

    def picture(self, path):
        path = pathlib.Path(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(base64.b64decode(self.cdp("Page.captureScreenshot", format="png")["data"]))

    def logs(self, kind):
        return self.ask("POST", "/se/log", {"type": kind})

    def errors(self):
        self.logged += self.logs("browser")
        return [entry["message"] for entry in self.logged if entry["level"] == "SEVERE"]

    def requests(self):
        """The addresses that were asked for since this was called last."""
        found = []
        for entry in self.logs("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                found.append(message["params"]["request"]["url"])
        return found

    def end(self):
        try:
            self.ask("DELETE", "")
        except (Refused, OSError):
            pass
        self.driver.terminate()
        self.driver.wait()
        if self.own:
            shutil.rmtree(self.profile, ignore_errors=True)
        shutil.rmtree(self.downloads, ignore_errors=True)


def pixels(path):
    """Width, height and the rows of red, green and blue of a PNG file of eight bits."""
    data = pathlib.Path(path).read_bytes()
    at, packed, head = 8, b"", None
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            head = body
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    width, height = (int.from_bytes(head[i:i + 4], "big") for i in (0, 4))
    size = {2: 3, 6: 4}[head[9]]
    raw, stride, rows = zlib.decompress(packed), width * size, []
    before = bytes(stride)
    for row in range(height):
        begin = row * (stride + 1)
        kind, line = raw[begin], bytearray(raw[begin + 1:begin + 1 + stride])
        for i in range(stride):
            left = line[i - size] if i >= size else 0
            up, corner = before[i], before[i - size] if i >= size else 0
            if kind == 1:
                line[i] = (line[i] + left) & 255
            elif kind == 2:
                line[i] = (line[i] + up) & 255
            elif kind == 3:
                line[i] = (line[i] + (left + up) // 2) & 255
            elif kind == 4:
                p = left + up - corner
                nearest = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
                line[i] = (line[i] + nearest) & 255
        before = bytes(line)
        rows.append([before[i:i + 3] for i in range(0, stride, size)])
    return width, height, rows


def difference(one, other, columns=None, block=8):
    """The share of blocks of so many pixels a side whose mean colour differs by more than a twentieth of the range; of the
    first `columns` alone where they are given."""
    (width, height, a), (other_width, other_height, b) = pixels(one), pixels(other)
    if (width, height) != (other_width, other_height):
        raise Refused(f"{one} is {width}x{height}, {other} is {other_width}x{other_height}")

    def mean(rows, x, y):
        sums = [0, 0, 0]
        for row in rows[y:y + block]:
            for pixel in row[x:x + block]:
                for channel in range(3):
                    sums[channel] += pixel[channel]
        return [total / block**2 for total in sums]

    differ = count = 0
    for y in range(0, height - block + 1, block):
        for x in range(0, (columns or width) - block + 1, block):
            count += 1
            differ += any(abs(p - q) > 12.75 for p, q in zip(mean(a, x, y), mean(b, x, y)))
    return differ / count


def text_of(browser):
    """All that can be read on the screen, in its order, but for times and for what is still computed."""
    words = [node["value"] or node["name"] for node in browser.nodes() if node["role"] in ("Label", "TextInput", "SpinButton", "Slider")]
    return [word for word in words if word and not re.search(r" ms\b|milliseconds|Computing|Up to date", word)]


CTRL, SHIFT, ALT = 2, 8, 1

# Times what is computed and drawn in each frame, before it is handed to the graphics processor.
TIMED = """
window.frames_taken = [];
const request = window.requestAnimationFrame.bind(window);
window.requestAnimationFrame = (then) => request((time) => {
    const begin = performance.now();
    then(time);
    window.frames_taken.push(performance.now() - begin);
});
"""

# The browser keeps nothing.
THROWS = "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); };"

SIZE = (1280, 800)


def middle(node):
    return node["x"] + node["width"] / 2, node["y"] + node["height"] / 2


def value_of(browser, name, role=None):
    node = browser.find(name, role)
    return node and (node["value"] or node["name"])


def is_said(browser, words):
    return lambda: any(words in (node["value"] or node["name"] or "") for node in browser.nodes())


def drop(browser, text, name):
    """Drops a file of this text on the page."""
    browser.js(f"""
        const carried = new DataTransfer();
        carried.items.add(new File([{json.dumps(text)}], {json.dumps(name)}));
        const canvas = document.getElementById("explorer");
        for (const kind of ["dragenter", "dragover", "drop"])
            canvas.dispatchEvent(new DragEvent(kind, {{
                dataTransfer: carried, bubbles: true, cancelable: true, clientX: 600, clientY: 400,
            }}));
    """)


def downloaded(browser, ending):
    """The bytes of a file whose name ends so, once it is complete."""
    def found():
        return next((path for path in browser.downloads.iterdir() if path.suffix == ending and path.stat().st_size), None)
    return browser.wait(f"a download of {ending}", found).read_bytes()


def link_of(browser):
    """Copies a link, which the address then shows."""
    before = browser.js("return location.hash")
    browser.key("k", modifiers=CTRL | SHIFT)
    return browser.wait("a link", lambda: (lambda now: now if now != before else None)(browser.js("return location.hash")))


def looks_at_the_folder(folder):
    page = (folder / "index.html").read_text()
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page)
    rules = dict(rule.strip().split(" ", 1) for rule in policy[1].split(";"))
    check(rules["default-src"] == "'self'", "nothing is loaded but from the page's own folder")
    check(rules["script-src"] == "'self' 'wasm-unsafe-eval'", "scripts are the page's own, and none stands in it")
    check(not re.search(r"<script[^>]*>\s*[^<\s]", page), "no script stands in index.html")
    check(not re.search(r"\son\w+=", page), "no element of index.html has a script")
    loaded = ["index.html", "explorer.js", "explorer.wasm.gz", "icon.png"]
    size = sum((folder / name).stat().st_size for name in loaded)
    check(size <= 6 << 20, f"all that is loaded: {size / (1 << 20):.2f} MiB")
    check("MIT" in (folder / "licences.txt").read_text(), "licences are there")


def is_used(browser, server, folder, program):
    begin = time.monotonic()
    browser.cdp("Page.addScriptToEvaluateOnNewDocument", source=TIMED)
    browser.start(server.address)
    print(f"figure: {time.monotonic() - begin:.1f} s from the address to the first frame", flush=True)
    browser.seen("Skip", "Button")
    time.sleep(2)
    own, drawn = folder.parent / "page.png", folder.parent / "desktop.png"
    browser.click(browser.seen("Skip", "Button"))
    time.sleep(2)
    browser.mouse("mouseMoved", 640, 790)
    browser.picture(own)
    theme = browser.js("return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'")
    subprocess.run([program, "render", "--size", "1280x800", "--theme", theme, "-o", drawn], check=True)
    # Pictures have no captions above their views, which move these down by a line.
    share, panel = difference(own, drawn), difference(own, drawn, columns=264)
    said = f"{100 * share:.1f} % of the blocks of 8 by 8 pixels differ, in the panel at the side {100 * panel:.1f} %"
    check(share < 0.1 and panel < 0.02, f"the page looks as on the desktop: {said}")

    light = browser.seen("Light in the polar")
    before = value_of(browser, r"θ .*f .*1/sr", "Label")
    (x, y) = middle(light)
    browser.js("window.frames_taken.length = 0")
    browser.drag((x, y), (x + 60, y - 30), steps=40)
    browser.wait("the value to change", lambda: value_of(browser, r"θ .*f .*1/sr", "Label") != before)
    taken = sorted(browser.js("return window.frames_taken"))
    print(f"figure: while the light is dragged a frame takes {taken[len(taken) // 2]:.0f} ms, 95 of 100 at most {taken[int(0.95 * (len(taken) - 1))]:.0f} ms", flush=True)
    check(browser.find("Light in the polar")["value"] != light["value"], "the light is dragged by the mouse, and the number changes")

    browser.click(browser.seen("Roughness along s", "SpinButton"))
    browser.key("a", modifiers=CTRL)
    browser.type("0.345")
    browser.key("Enter", text="\r")
    browser.wait("the number typed", lambda: value_of(browser, "Roughness along t", "SpinButton") == "0.345")
    check(value_of(browser, "Roughness along s", "SpinButton") == "0.345", "a number is typed key by key: 0.345")

    first = link_of(browser)
    check(first.startswith("#s=") and len(first) < 2000, f"a link to all of it: {len(first)} characters")
    one = text_of(browser)
    browser.click(browser.seen("Roughness along s", "SpinButton"))
    browser.key("a", modifiers=CTRL)
    browser.type("0.8")
    browser.key("Enter", text="\r")
    browser.wait("the number typed", lambda: value_of(browser, "Roughness along s", "SpinButton") == "0.8")
    second = link_of(browser)
    browser.js("history.back()")
    browser.wait("the state before", lambda: value_of(browser, "Roughness along s", "SpinButton") == "0.345")
    browser.js("history.forward()")
    browser.wait("the state after it", lambda: value_of(browser, "Roughness along s", "SpinButton") == "0.8")
    check(True, "back and forward step through the states that were linked")

    other = Browser(SIZE)
    try:
        other.start(server.address + first)
        other.wait("the state of the link", lambda: value_of(other, "Roughness along s", "SpinButton") == "0.345")
        if other.find("Skip", "Button"):
            other.click(other.find("Skip", "Button"))
        time.sleep(1)
        lost = [word for word in one if word not in text_of(other) and "clipboard" not in word]
        check(not lost, f"a link opens the same state elsewhere {lost[:3] or ''}")
        other.js("location.hash = '#s=' + location.hash.slice(3, -9)")
        other.wait("a line about the link", is_said(other, "cut off or damaged"))
        check(value_of(other, "Roughness along s", "SpinButton") == "0.345", "a link that is cut is told of, and all stays")
        check(not other.errors(), "no error on its console")
    finally:
        other.end()

    drop(browser, '[[lobes]]\nmodel = "phong"\nexponent = 20\n', "my.toml")
    browser.seen("Show Phong", "CheckBox")
    check(True, "a material is dropped")
    browser.key("s", modifiers=CTRL)
    check(b"BRDF Explorer session" in downloaded(browser, ".toml"), "the session is downloaded")
    for name, ending, begins in (("PNG", ".png", b"\x89PNG"), ("SVG", ".svg", b"<")):
        browser.key("e", modifiers=CTRL)
        browser.click(browser.seen(rf"\({name}\)", "Button"))
        check(downloaded(browser, ending).startswith(begins), f"a figure is downloaded as {name}")
    time.sleep(2.5)
    browser.start(server.address)
    browser.seen("Show Phong", "CheckBox")
    check(value_of(browser, "Exponent", "SpinButton") == "20", "the next visit begins where the last one ended")


def teaches(server, folder):
    browser = Browser(SIZE)
    try:
        browser.start(server.address + "#lesson=06-lambert.2")
        field = browser.seen("Your answer")
        browser.click(field)
        browser.type("3.14159")
        browser.key("Enter", text="\r")
        browser.wait("the verdict", is_said(browser, "Right"))
        check(True, "a step of a lesson is opened by its link, and answered")
        browser.picture(folder.parent / "lesson.png")
        browser.start(server.address + "?embed=1&theme=dark#lesson=06-lambert.2")
        browser.seen("Next", "Button")
        check(browser.find("File", "Button") is None, "a step stands within another page without menus")
        browser.start(server.address + "?embed=1&theme=dark")
        browser.seen("Light in the 3D lobe")
        check(browser.find("Change", "Button") is None, "so does a view")
        check(not browser.errors(), "no error on the console")
    finally:
        browser.end()


def is_touched(server, folder):
    browser = Browser((390, 844), touch=True)
    try:
        browser.start(server.address)
        browser.wait("a handle", lambda: browser.find("^Light in"))
        time.sleep(2)
        browser.picture(folder.parent / "phone.png")
        light = browser.find("^Light in")
        (x, y) = middle(light)
        browser.touch((x, y), (x + 30, y - 20))
        browser.wait("the light to move", lambda: browser.find("^Light in")["value"] != light["value"])
        check(True, "the light is dragged by a finger, on a screen of 390 by 844")
        check(not browser.errors(), "no error on the console")
    finally:
        browser.end()


def works_without_a_network(server):
    browser = Browser(SIZE)
    try:
        browser.start(server.address)
        browser.seen("Skip", "Button")
        begin = browser.requests()
        own = [address for address in begin if address.startswith("http") and not address.startswith(server.address)]
        check(not own, f"nothing is asked for beside the page's folder {own[:3] or ''}")
        browser.cdp("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
        for name in ("Compare", "Reflectance", "Sampling", "Numerics", "Look"):
            browser.click(browser.seen(f"^{name}$", "Button"))
            time.sleep(2)
        browser.key("l", modifiers=CTRL)
        browser.wait("the lessons", is_said(browser, "Lambert"))
        # Their field has the keyboard until it is left.
        browser.key("Escape")
        time.sleep(1)
        link_of(browser)
        browser.key("s", modifiers=CTRL)
        downloaded(browser, ".toml")
        kept = browser.wait("the session to be kept", lambda: browser.js("return localStorage['brdf-explorer/session.toml']"))
        check("BRDF Explorer session" in kept, "without a network views, lessons, links, downloads and keeping go on")
        asked = [address for address in browser.requests() if address.startswith("http")]
        check(not asked, f"and nothing is asked for {asked[:3] or ''}")
        check(not browser.errors(), "no error on the console")
    finally:
        browser.end()


def fails_well(server):
    browser = Browser(SIZE)
    try:
        browser.cdp("Page.addScriptToEvaluateOnNewDocument", source=THROWS)
        browser.start(server.address)
        browser.wait("a line about it", is_said(browser, "keeps nothing for the next visit"))
        check(True, "a browser that keeps nothing is told of")
        has_context = browser.js("""
            const context = document.getElementById("explorer").getContext("webgl2");
            context?.getExtension("WEBGL_lose_context").loseContext();
            return !!context;
        """)
        if has_context:
            browser.wait("a sentence", lambda: not browser.js("return document.getElementById('before').hidden"))
            check(not browser.js("return document.getElementById('again').hidden"), "a lost drawing context is told of, with a button")
    finally:
        browser.end()
    browser = Browser(SIZE)
    try:
        browser.cdp("Page.addScriptToEvaluateOnNewDocument", source="WebAssembly.validate = () => false;")
        browser.go(server.address)
        told = browser.wait("a sentence", lambda: browser.js("return document.getElementById('said').textContent"))
        check("SIMD" in told and not browser.js("return document.getElementById('picture').hidden"), "a browser without vectors gets a sentence and a picture")
    finally:
        browser.end()


def main():
    folder, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    looks_at_the_folder(folder)
    server = Server(folder)
    browser = Browser(SIZE)
    try:
        is_used(browser, server, folder, program)
        check(not browser.errors(), f"no error on the console")
        memory = browser.js("return window.explorer_memory?.buffer.byteLength ?? 0")
        print(f"figure: WebAssembly.Memory {memory / (1 << 20):.0f} MiB", flush=True)
    finally:
        browser.end()
    teaches(server, folder)
    is_touched(server, folder)
    works_without_a_network(server)
    fails_well(server)
    print("The page passed all checks")


if __name__ == "__main__":
    try:
        main()
    except Refused as problem:
        sys.exit(f"FAILED: {problem}")
