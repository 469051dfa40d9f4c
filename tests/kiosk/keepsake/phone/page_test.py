"""The visitor's page in a real browser: every language, light and dark, on a narrow phone and on a tablet; the pot
that turns; what is taken, and deleting.

usage: page_test.py --console build/.../onggi-console [--every] [--keepsake DIR of a visit] [--pictures DIR]
Skipped (77) where there is no chromium.
"""
import argparse
import itertools
import json
import math
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import browser as browsers  # noqa: E402
import slow_way  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[4]
VISIT = "2026-05-04_141503_moon_jar"
LANGUAGES = {p.stem: tomllib.loads(p.read_text()) for p in sorted((ROOT / "content/languages").glob("*.toml"))}
# A narrow phone, and a tablet held upright.
SIZES = {"phone": (360, 640), "tablet": (820, 1180)}

# The pot as it is drawn two frames from now, 48 x 48 and see-through round it.
POT = """new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const small = document.createElement("canvas"), on = small.getContext("2d", { willReadFrequently: true });
  small.width = small.height = 48;
  on.drawImage(document.getElementById("pot"), 0, 0, 48, 48);
  done([...on.getImageData(0, 0, 48, 48).data]);
})))"""

NO_WEBGL = """HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
  apply: (real, canvas, [kind, ...more]) => kind.startsWith("webgl") ? null : real.call(canvas, kind, ...more) });"""


def lopsided(glb):
    """A pot that looks another from each side: a round one hides that it turns."""
    length = struct.unpack_from("<I", glb, 12)[0]
    gltf, out = json.loads(glb[20:20 + length]), bytearray(glb)
    accessor = gltf["accessors"][gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
    view = gltf["bufferViews"][accessor["bufferView"]]
    at = 20 + length + 8 + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    for n in range(accessor["count"]):
        x, y, z = struct.unpack_from("<fff", glb, at + 12 * n)
        struct.pack_into("<f", out, at + 12 * n, x if x > 0 else 0.4 * x)
    return bytes(out)


def png_of(rows):
    """Of rows of (r, g, b)."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + bytes(v for pixel in row for v in pixel) for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def two_coloured(rough, painted=False):
    """A ball, red below and blue above, where it is so rough, as the kiosk writes a glazed pot; `painted`: by a picture."""
    places, normals, colours, spots, halves = [], [], [], [], ([], [])
    for row in range(9):
        for k in range(32):
            round_, up = k * math.pi / 16, (row - 4) * math.pi / 8
            normals += [math.cos(up) * math.cos(round_), math.sin(up), math.cos(up) * math.sin(round_)]
            places += [0.5 * v for v in normals[-3:]]
            colours += [65535, 6000, 0, 65535] if row < 4 else [0, 6000, 65535, 65535]
            spots += [k / 32, 0.75 if row < 4 else 0.25]
            if row < 8:
                a, b = row * 32 + k, row * 32 + (k + 1) % 32
                halves[row >= 4].extend([a, a + 32, b, b, a + 32, b + 32])
    parts = [struct.pack(f"<{len(v)}{t}", *v) for t, v in (("f", places), ("f", normals), ("I", halves[0] + halves[1]),
                                                         ("f", spots) if painted else ("H", colours))]
    if painted:
        red, blue = (230, 60, 10), (10, 60, 230)
        picture = png_of([[blue] * 4] * 2 + [[red] * 4] * 2)
        parts.append(picture + bytes(-len(picture) % 4))
    views, at = [], 0
    for part in parts:
        views.append({"buffer": 0, "byteOffset": at, "byteLength": len(part)})
        at += len(part)
    corners = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0" if painted else "COLOR_0": 3}
    colour = {"baseColorTexture": {"index": 0}} if painted else {"baseColorFactor": [0.8, 0.8, 0.5, 1]}
    coats = [{"pbrMetallicRoughness": {**colour, "roughnessFactor": r}} for r in (0.7, rough)]
    picture = {"images": [{"bufferView": 4, "mimeType": "image/png"}], "textures": [{"source": 0}]} if painted else {}
    fourth = {"componentType": 5126, "type": "VEC2"} if painted else {"componentType": 5123, "type": "VEC4", "normalized": True}
    text = json.dumps({
        **picture,
        "asset": {"version": "2.0"}, "materials": coats, "bufferViews": views, "buffers": [{"byteLength": at}],
        "meshes": [{"primitives": [{"attributes": corners, "indices": 2 + 2 * n, "material": n} for n in (0, 1)]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 288, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5126, "count": 288, "type": "VEC3"},
                      {"bufferView": 2, "componentType": 5125, "count": 768, "type": "SCALAR"},
                      {"bufferView": 3, "count": 288, **fourth},
                      {"bufferView": 2, "byteOffset": 3072, "componentType": 5125, "count": 768, "type": "SCALAR"}]})
    text += " " * (-len(text) % 4)
    head = struct.pack("<IIIII", 0x46546c67, 2, 28 + len(text) + at, len(text), 0x4e4f534a)
    return head + text.encode() + struct.pack("<II", at, 0x004e4942) + b"".join(parts)


def covered(picture):
    return sum(a > 0 for a in picture[3::4]) / (len(picture) / 4)


def changed(one, other):
    return sum(abs(a - b) for a, b in zip(one, other)) / len(one)


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="onggi-page-"))
        cls.kept = cls.folder / "kept"
        cls.server = subprocess.Popen(
            [ARGUMENTS.console, "--phone-only", "--keepsakes", str(cls.make()), "--listen", "127.0.0.1:0"],
            stdout=subprocess.PIPE, text=True)
        cls.at = "http://127.0.0.1:" + re.search(r"port (\d+)", cls.server.stdout.readline())[1]
        cls.browser = browsers.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.server.terminate()
        cls.server.wait()
        cls.server.stdout.close()
        shutil.rmtree(cls.folder)

    @classmethod
    def make(cls):
        """A folder of keepsakes with a visit in it."""
        visit = cls.kept / VISIT
        if ARGUMENTS.keepsake:
            shutil.copytree(ARGUMENTS.keepsake, visit)
            return cls.kept
        visit.mkdir(parents=True)
        (visit / "pot.glb").write_bytes(lopsided((ROOT / "content/vessels/moon_jar/vessel.glb").read_bytes()))
        (visit / "turning.gif").write_bytes(random.Random(8).randbytes(3_000_000))
        (visit / "pot.stl").write_bytes(random.Random(7).randbytes(14_000_000))
        # A picture of a postcard's shape: whoever shows it looks at its bytes, not at its name.
        (visit / "postcard.jpg").write_bytes((ROOT / "kiosk/docs/pictures/sheet.png").read_bytes())
        return cls.kept

    def token(self, visit=VISIT, hours=24.0):
        return subprocess.run([ARGUMENTS.console, "--pass", str(self.kept / visit), "--hours", str(hours)], check=True,
                              capture_output=True, text=True).stdout.strip()

    def page(self, size="phone", **kept):
        return self.browser.page(*SIZES[size], **kept)

    def looked_at(self, page, name):
        """Nothing on it is amiss, and nobody but the kiosk was asked."""
        looks = page.value(browsers.LAYOUT)
        self.assertEqual(looks["found"], [], name)
        self.assertGreater(looks["words"], 0, name)
        self.assertEqual(page.complaints(), [], name)
        elsewhere = [a for a in page.asked() if not a.startswith((self.at, "about:", "blob:"))]
        self.assertEqual(elsewhere, [], name)
        if ARGUMENTS.pictures:
            pathlib.Path(ARGUMENTS.pictures).mkdir(parents=True, exist_ok=True)
            page.picture(pathlib.Path(ARGUMENTS.pictures) / (name + ".png"))

    def test_every_language_light_and_dark_on_a_narrow_phone_and_a_tablet(self):
        token = self.token()
        every = list(itertools.product(LANGUAGES, (False, True), SIZES))
        # In each run of the tests each language once, in turn light and dark, narrow and wide; --every has all.
        some = [(code, n % 2 == 1, ("phone", "phone", "tablet")[n % 3]) for n, code in enumerate(LANGUAGES)]
        for code, dark, size in every if ARGUMENTS.every else some:
            words = LANGUAGES[code]
            said = words["text"]["phone"]
            name = f"{code}_{'dark' if dark else 'light'}_{size}"
            with self.page(size, dark=dark, languages="ko" if code == "de" else "en", scale=1) as page:
                page.go(f"{self.at}{token}?lang={code}")
                page.wait("!document.getElementById('turning').hidden", "the pot is shown")
                self.assertEqual(page.value("document.documentElement.lang"), code)
                self.assertEqual(page.value("getComputedStyle(document.body).direction"),
                                 "rtl" if words["right_to_left"] else "ltr")
                shown = page.value("document.body.innerText")
                for key in ("title", "turn", "postcard", "model", "print", "until", "delete"):
                    self.assertIn(said[key], shown, name)
                self.assertNotIn(said["sure"], shown, "asked before anybody wants it")
                self.assertEqual(page.value("document.querySelector('img').naturalWidth > 0"), True)
                # The background is as dark as the phone wants it.
                back = page.value("getComputedStyle(document.body).backgroundColor.match(/\\d+/)[0] < 128")
                self.assertEqual(back, dark, name)
                page.value("document.querySelector('details').open = true")
                self.assertIn(said["sure"], page.value("document.body.innerText"))
                self.looked_at(page, name)

    def test_the_phones_own_language_is_one_tap_away(self):
        with self.page(languages="ja-JP,ja;q=0.9") as page:
            page.go(f"{self.at}{self.token()}?lang=ar")
            page.arriving(lambda: page.tap(".own a"), "the page in Japanese")
            self.assertEqual(page.value("document.documentElement.lang"), "ja")
            self.looked_at(page, "own_language")

    def test_the_pot_turns_by_a_finger_and_tilts_and_grows_by_two(self):
        with self.page() as page:
            page.go(self.at + self.token())
            page.wait("!document.getElementById('turning').hidden", "the pot is shown")
            x, y = page.middle("#pot")
            rest = page.value(POT)
            self.assertTrue(0.1 < covered(rest) < 0.9, covered(rest))
            self.assertEqual(changed(rest, page.value(POT)), 0, "it stands still where motion is not wanted")

            def drag(*steps):
                before = page.value(POT)
                for n, places in enumerate(steps):
                    page.fingers("touchMove" if n else "touchStart", places)
                page.fingers("touchEnd", [])
                return before, page.value(POT)

            before, after = drag([(x, y)], [(x + 20, y)], [(x + 90, y)])
            self.assertGreater(changed(before, after), 0.2, "one finger turns")
            apart = [(x - 30, y), (x + 30, y)]
            before, after = drag(apart, [(x - 50, y), (x + 50, y)], [(x - 60, y), (x + 60, y)])
            self.assertGreater(covered(after), 1.3 * covered(before), "two that part bring it near")
            before, after = drag([(x - 60, y), (x + 60, y)], apart)
            self.assertLess(covered(after), 0.8 * covered(before), "two that close send it away")
            before, after = drag(apart, [(x - 30, y + 40), (x + 30, y + 40)], [(x - 30, y + 60), (x + 30, y + 60)])
            self.assertGreater(changed(before, after), 1.0, "two that go down tilt it")
            # By a mouse, and by keys.
            before = page.value(POT)
            for kind, dx in (("mousePressed", 0), ("mouseMoved", 60), ("mouseReleased", 60)):
                page.say("Input.dispatchMouseEvent", type=kind, x=x + dx, y=y, button="left", buttons=1, clickCount=1)
            self.assertGreater(changed(before, page.value(POT)), 0.2)
            before = page.value(POT)
            page.value("document.getElementById('pot').focus()")
            for kind in ("keyDown", "keyUp"):
                page.say("Input.dispatchKeyEvent", type=kind, key="ArrowUp", code="ArrowUp")
            self.assertGreater(changed(before, page.value(POT)), 0.2)
            self.looked_at(page, "turned")

    def test_it_turns_by_itself_where_motion_is_welcome(self):
        with self.page(still=False) as page:
            page.go(self.at + self.token())
            page.wait("!document.getElementById('turning').hidden", "the pot is shown")
            before = page.value(POT)
            time.sleep(0.5)
            self.assertGreater(changed(before, page.value(POT)), 0.05)

    def test_the_pot_is_shown_in_its_glaze_and_what_is_smooth_shines(self):
        glazed, brightest = "2026-05-04_180000_glazed", {}
        shutil.copytree(self.kept / VISIT, self.kept / glazed)
        for rough, painted in ((0.12, False), (0.7, False), (0.12, True), (0.7, True)):
            (self.kept / glazed / "pot.glb").write_bytes(two_coloured(rough, painted))
            with self.page() as page:
                page.go(self.at + self.token(glazed))
                page.wait("!document.getElementById('turning').hidden", "the pot is shown")
                seen = page.value(POT)
                pixels = [seen[4 * n:4 * n + 4] for n in range(48 * 48)]
                above = [p for p in pixels[:48 * 20] if p[3] > 250]
                below = [p for p in pixels[48 * 34:] if p[3] > 250]
                self.assertGreater(len([p for p in above if p[2] > p[0] + 60]), 100, "blue above")
                self.assertGreater(len([p for p in below if p[0] > p[2] + 60]), 100, "red below")
                brightest[rough, painted] = max(p[0] for p in above)  # blue has no red of its own
                self.looked_at(page, f"{'painted' if painted else 'glazed'}_{rough}")
        for painted in (False, True):
            self.assertGreater(brightest[0.12, painted], brightest[0.7, painted] + 60, "a window is seen in glass and not in clay")

    def test_without_webgl_or_with_a_broken_pot_the_postcard_stays(self):
        broken = "2026-05-04_160000_broken"
        shutil.copytree(self.kept / VISIT, self.kept / broken)
        (self.kept / broken / "pot.glb").write_bytes(b"no pot at all, and too short for one")
        for visit, before in ((VISIT, NO_WEBGL), (broken, None)):
            with self.page(before=before) as page:
                page.go(self.at + self.token(visit))
                self.browser.until(lambda: any("pot.glb" in e for e in page.asked()), "the pot is asked for")
                time.sleep(0.5)
                self.assertFalse(page.value("document.getElementById('turning').checkVisibility()"))
                self.assertTrue(page.value("document.querySelector('img').checkVisibility()"))
                self.looked_at(page, "no_webgl" if before else "broken_pot")

    def test_what_is_taken_is_whole_to_the_byte(self):
        with self.page() as page:
            page.go(self.at + self.token())
            to = self.folder / "taken"
            self.browser.say("Browser.setDownloadBehavior", behavior="allow", browserContextId=page.context,
                             downloadPath=str(to), eventsEnabled=True)
            for file in ("postcard.jpg", "turning.gif", "pot.glb", "pot.stl"):
                page.tap(f'a.take[href$="{file}"]')
                self.browser.until(lambda: (to / file).is_file() and
                                   (to / file).stat().st_size == (self.kept / VISIT / file).stat().st_size, file)
                self.assertEqual((to / file).read_bytes(), (self.kept / VISIT / file).read_bytes(), file)

    def test_over_a_slow_way_that_breaks_the_pot_goes_on_from_where_it_stopped(self):
        port = int(self.at.rsplit(":", 1)[1])
        size = (self.kept / VISIT / "pot.glb").stat().st_size
        with slow_way.SlowWay(port, breaks=("pot.glb",), after=size // 2) as way, self.page() as page:
            page.go(f"http://127.0.0.1:{way.port}{self.token()}")
            page.wait("!document.getElementById('turning').hidden", "the pot is shown", 60.0)
            self.assertTrue(0.1 < covered(page.value(POT)) < 0.9, "and whole")
            self.assertEqual(page.value("document.querySelector('img').naturalWidth > 0"), True)
            spans = [int(span.split("=")[1].rstrip("-")) for line, span in way.asked if "pot.glb" in line and span]
            self.assertGreater(len(spans), 0, way.asked)
            self.assertEqual(spans, sorted(spans), "each goes on, and none begins anew")
        # What is taken by a slow phone is whole as well.
        with slow_way.SlowWay(port) as way, self.page() as page:
            page.go(f"http://127.0.0.1:{way.port}{self.token()}")
            to = self.folder / "slowly"
            self.browser.say("Browser.setDownloadBehavior", behavior="allow", browserContextId=page.context,
                             downloadPath=str(to), eventsEnabled=True)
            page.tap('a.take[href$="pot.stl"]')
            whole = (self.kept / VISIT / "pot.stl").read_bytes()
            self.browser.until(lambda: (to / "pot.stl").is_file() and (to / "pot.stl").stat().st_size == len(whole), "pot.stl", 60.0)
            self.assertEqual((to / "pot.stl").read_bytes(), whole)

    def test_deleting_asks_first_and_then_nothing_is_left_of_it_not_even_behind_the_back_button(self):
        visit = "2026-05-04_150000_meiping"
        shutil.copytree(self.kept / VISIT, self.kept / visit)
        token = self.token(visit)
        said = LANGUAGES["fr"]["text"]["phone"]
        with self.page(languages="fr") as page:
            page.go(self.at + token)
            self.assertFalse(page.value("document.querySelector('button').checkVisibility()"))
            page.tap("summary")
            page.wait("document.querySelector('button').checkVisibility()", "it asks")
            self.assertIn(said["sure"], page.value("document.body.innerText"))
            self.assertTrue((self.kept / visit).is_dir())
            page.arriving(lambda: page.tap("form button"), "it is deleted")
            self.assertEqual(page.value("document.body.innerText").strip(), said["deleted"])
            self.looked_at(page, "deleted")
            self.assertEqual(sorted(p.name for p in self.kept.glob(visit + "*")), [])
            page.arriving(lambda: page.value("history.back()"), "back")
            self.assertEqual(page.value("document.body.innerText").strip(), said["nothing"])

    def test_an_expired_page_says_so_in_the_phones_language(self):
        token = self.token(hours=0.0003)
        time.sleep(2.2)
        with self.page(languages="zh-CN", dark=True) as page:
            page.go(self.at + token)
            self.assertEqual(page.value("document.body.innerText").strip(), LANGUAGES["zh"]["text"]["phone"]["nothing"])
            self.assertEqual(page.value("document.images.length"), 0)
            # That there is nothing (404) is no fault of the page's.
            page.browser.events = [e for e in page.browser.events if "404" not in str(e)]
            self.looked_at(page, "expired")

    def test_the_test_itself_finds_what_is_amiss(self):
        """A page that does all that is forbidden is complained of."""
        with self.page() as page:
            page.go(self.at + self.token())
            page.value("""document.body.insertAdjacentHTML("beforeend", '<p style="color: #ddd; width: 500px">faint</p>'),
              document.querySelector("p:last-child").style.cssText = "color: #ddd; width: 500px",
              document.body.append(Object.assign(new Image(), { src: "http://elsewhere.invalid/x.png" })),
              setTimeout(() => console.error("wrong"))""")
            self.browser.until(lambda: len(page.complaints()) >= 2, "complaints")
            self.assertTrue(any("Content Security Policy" in c for c in page.complaints()), page.complaints())
            found = page.value(browsers.LAYOUT)["found"]
            self.assertTrue(any("stands out" in f for f in found) and any("outside" in f for f in found), found)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--console", required=True)
    parser.add_argument("--keepsake")
    parser.add_argument("--every", action="store_true")
    parser.add_argument("--pictures")
    ARGUMENTS, rest = parser.parse_known_args()
    if browsers.program() is None:
        print("There is no chromium here: the page is looked at in no browser.")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *rest])
