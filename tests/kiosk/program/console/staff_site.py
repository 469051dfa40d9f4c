"""What tests of the staff's page stand on: an exhibit, onggi-console and a browser. Its user calls main()."""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[4]
sys.path.insert(0, str(ROOT / "tests/kiosk/keepsake/phone"))
import browser as browsers  # noqa: E402

SIZES = {"desk": (1280, 800), "tablet": (820, 1180), "phone": (360, 740)}
PARTS = {"now": "#lines li", "desk": "#found:not(:empty)", "figures": "#figures-words:not(:empty)", "files": "#files-list li",
         "settings": "#settings-fields fieldset", "shelf": "#shelf-list li", "lists": "#list-body fieldset", "scenes": "#scenes-list li", "words": "#words-body details", "people": "#people-list"}
# Every page: the part, and what is opened in it.
PAGES = {part: (part, ()) for part in PARTS}
PAGES.update({
    "keepsake": ("desk", ((".pot", "document.getElementById('pot').open"),)),
    "passphrase": ("now", (("#own", "document.getElementById('passphrase').open"),)),
    "label": ("shelf", (("#shelf-list li > button", "!document.getElementById('label').hidden"),)),
    "scan": ("shelf", (("#scan summary", "document.getElementById('scan').open"),)),
    "scene": ("scenes", (("#scenes-list button", "!document.getElementById('scene').hidden"),)),
    "look": ("settings", (("#settings-form .see", "document.getElementById('look').open"),)),
    "word": ("words", (("#words-body summary", "!!document.querySelector('#words-body details[open] input, #words-body details[open] textarea')"),)),
    "taken back": ("settings", (("[data-part=settings] > details summary", "document.querySelector('[data-part=settings] > details').open"),)),
})
JAR, OLLA = "2026-05-28_141503_moon_jar", "2026-05-28_101500_olla"


ARGUMENTS = None


class StaffSite(unittest.TestCase):
    """An exhibit with two keepsakes, the program that serves its page, and a browser."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-staff-"))
        shutil.copytree(ROOT / "config", self.folder / "config")
        for name in ("languages", "lessons", "ways", "vessels/moon_jar"):
            shutil.copytree(ROOT / "content" / name, self.folder / "content" / name)
        for name in ("glazes.toml", "missions.toml", "names.toml"):
            shutil.copy(ROOT / "content" / name, self.folder / "content" / name)
        self.exhibit = self.folder / "config/exhibit.toml"
        self.kept = self.folder / "keepsakes"
        for visit in (JAR, OLLA):
            (self.kept / visit).mkdir(parents=True)
            for name in ("postcard.jpg", "small.jpg"):  # its bytes say what it is
                shutil.copy(ROOT / "kiosk/docs/pictures/sheet.png", self.kept / visit / name)
        (self.kept / JAR / "name.txt").write_text("quiet-blue-heron\n")
        self.site = [ARGUMENTS.console, "--site", str(self.folder), "--state", str(self.folder / "state")]
        self.console = subprocess.Popen([*self.site, "--listen", "127.0.0.1:0"],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        said = self.console.stdout.readline() + self.console.stdout.readline()
        self.way_in = re.search(r"http://\S+", said)[0]
        self.at = self.way_in[:self.way_in.index("/?")]
        self.browser = browsers.Browser()

    def tearDown(self):
        self.browser.__exit__()
        self.console.terminate()
        self.console.wait()
        self.console.stdout.close()
        self.console.stderr.close()
        shutil.rmtree(self.folder)

    def page(self, size="desk", **kept):
        return self.browser.page(*SIZES[size], scale=1, **kept)

    def open(self, page, part="now"):
        page.go(f"{self.at}/#{part}")
        page.wait("!!document.querySelector('" + PARTS[part] + "')", part)

    def looked_at(self, page, name, but=None):
        """Laid out well, without a complaint (`but` one with these words), and kept as a picture where asked for."""
        looks = page.value(browsers.LAYOUT)
        self.assertEqual(looks["found"], [], name)
        self.assertGreater(looks["words"], 0, name)
        self.assertEqual([c for c in page.complaints() if not but or but not in c], [], name)
        self.assertEqual([a for a in page.asked() if not a.startswith((self.at, "about:", "data:"))], [], name)
        if ARGUMENTS.pictures:
            pathlib.Path(ARGUMENTS.pictures).mkdir(parents=True, exist_ok=True)
            page.picture(pathlib.Path(ARGUMENTS.pictures) / (name + ".png"))

    def seen(self, page, name, selector):
        """Keeps what a window shows with `selector` in its middle, where pictures are asked for."""
        if ARGUMENTS.pictures:
            page.middle(selector)
            page.picture(pathlib.Path(ARGUMENTS.pictures) / (name + ".png"), whole=False)

    def text(self, page, selector):
        return page.value(f"document.querySelector({selector!r}).innerText")

    @staticmethod
    def speaking(code):
        """Makes the browser's own language `code`, for page(before=...)."""
        return f"Object.defineProperty(navigator, 'languages', {{ get: () => [{code!r}] }});"

    def come_in(self, page, part="now"):
        page.go(self.way_in)
        page.wait("!!document.querySelector('#lines li')", "the state")
        page.value(f"location.hash = '#{part}'")
        page.wait(f"!!document.querySelector({PARTS[part]!r})", part)

    def show(self, page, name):
        """One of PAGES, in a browser that is in."""
        part, steps = PAGES[name]
        page.go(f"{self.at}/#{part}")
        page.wait("!!document.querySelector(" + repr(PARTS[part]) + ")", part)
        if name == "keepsake":
            page.value("document.getElementById('day').value = ''")
            page.tap("#find button")
            page.wait("document.querySelectorAll('#pots li').length === 2", "both keepsakes")
        for selector, ready in steps:
            page.tap(selector)
            page.wait(ready, selector)

    def cookie_to(self, page, other):
        """Lets `other` in as `page` is."""
        cookie = page.say("Network.getCookies")["cookies"][0]
        other.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)


def main():
    """Runs the tests of the program's file. Skipped (77) where there is no chromium."""
    global ARGUMENTS
    parser = argparse.ArgumentParser()
    parser.add_argument("--console", required=True)
    parser.add_argument("--onggi", required=True)
    parser.add_argument("--every", action="store_true")
    parser.add_argument("--pictures")
    ARGUMENTS, rest = parser.parse_known_args()
    if browsers.program() is None:
        print("There is no chromium here: sudo apt install chromium")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *rest])


def checks():
    """Whether the program onggi is built, which the page asks about files."""
    return pathlib.Path(ARGUMENTS.onggi).exists()
