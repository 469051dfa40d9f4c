"""Seen before it is shown: a screen with what is typed and not saved, drawn by the kiosk's program, in a real browser.

usage: staff_look_test.py --console build/.../onggi-console --onggi build/.../onggi [--pictures DIR]
Skipped (77) where there is no chromium.
"""
import fcntl
import pathlib
import time

import staff_site

PATIENCE = 300  # s: it takes 6 s of two quiet cores, and waits while anything else wants one
ENDED = 20      # s until a process that is not wanted is gone


def drawers(site):
    """The processes that draw a screen."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = entry.read_bytes().split(b"\0")
        except OSError:
            continue
        if b"--page" in words and any(str(site).encode() in word for word in words):
            found.append(entry.parent.name)
    return found


class StaffLook(staff_site.StaffSite):
    def setUp(self):
        if not staff_site.checks():
            self.skipTest("onggi is not built here, and it draws the screens")
        super().setUp()

    def type(self, page, key, value):
        page.value(f"""(() => {{ const i = document.getElementById("field-exhibit-{key}");
            i.value = {value!r}; i.dispatchEvent(new Event("input", {{bubbles: true}})); }})()""")

    def drawn(self, page):
        """Waits for the pictures, and tells them: [(width, height, digest of the bytes)]."""
        page.wait("document.querySelectorAll('#look-pictures:not(.old) img').length === 2"
                  " && [...document.querySelectorAll('#look-pictures img')].every((one) => one.complete)", "the pictures", PATIENCE)
        return page.value("[...document.querySelectorAll('#look-pictures img')].map((one) => [one.naturalWidth, one.naturalHeight])"), \
            self.bytes_of(page)

    def bytes_of(self, page):
        page.value("""Promise.all([...document.querySelectorAll('#look-pictures img')].map(async (one) =>
            [...new Uint8Array(await crypto.subtle.digest('SHA-256', await (await fetch(one.src)).arrayBuffer()))].join(' ')))
            .then((all) => { window.digests = all; })""")
        page.wait("!!window.digests", "their bytes")
        return page.value("(() => { const all = window.digests; window.digests = undefined; return all; })()")

    def choose(self, page, name, value):
        page.value(f"""(() => {{ const s = document.getElementById("look-{name}");
            s.value = {value!r}; s.dispatchEvent(new Event("change", {{bubbles: true}})); }})()""")
        page.wait("document.getElementById('look-pictures').classList.contains('old')", "it is drawn anew")

    def test_a_title_is_seen_before_it_is_saved_in_both_languages_and_larger(self):
        before = self.exhibit.read_text()
        with self.page() as page:
            self.come_in(page, "settings")
            page.wait("!!document.getElementById('look').showModal && !!document.querySelector('#settings-fields input')", "the form")
            page.tap("#settings-form .see")
            sizes, now = self.drawn(page)
            self.assertEqual(sizes, [[1280, 720], [1080, 1920]])
            self.assertIn("As it is now", self.text(page, "#look-words"))
            page.tap("#look-close")
            self.type(page, "title-en", "A pot of your own")
            page.wait("!document.getElementById('settings-save').disabled", "it is right")
            page.tap("#settings-form .see")
            _, typed = self.drawn(page)
            self.looked_at(page, "look")
            self.seen(page, "console_look", "#look-title")
            self.assertIn("not saved yet", self.text(page, "#look-words"))
            self.assertNotEqual(now, typed, "the title is on the screen")
            self.choose(page, "comfort", "larger_text")
            _, larger = self.drawn(page)
            self.choose(page, "language", "ko")
            _, korean = self.drawn(page)
            self.assertEqual(len({*now, *typed, *larger, *korean}), 8, "each is another picture")
            page.tap("#look-close")
            self.assertEqual(self.exhibit.read_text(), before)
            self.assertEqual(page.complaints(), [])

    def test_a_label_and_what_cannot_be_drawn(self):
        with self.page("phone") as page:
            self.come_in(page, "shelf")
            page.tap("#shelf-list button[aria-label^='Label']")
            page.wait("!document.getElementById('label').hidden", "the label")
            page.tap("#label-form .see")
            self.drawn(page)
            self.assertEqual(page.value("[document.getElementById('look-screen').value, document.getElementById('look-vessel').value]"), ["label", "moon_jar"])
            self.looked_at(page, "look_label")
            page.tap("#look-close")
            page.value("""(() => { const i = document.getElementById("field-vessel-moon_jar-true_height_mm");
                i.value = "-5"; i.dispatchEvent(new Event("input", {bubbles: true})); })()""")
            page.wait("document.getElementById('label-save').disabled", "it is wrong")
            page.tap("#label-form .see")
            page.wait("!!document.getElementById('look-words').querySelector('strong')", "what is wrong")
            self.assertIn("smallest allowed value", self.text(page, "#look-words"))

    def test_a_visitor_comes_first(self):
        now = int(time.time())
        state = (f"version 0.1.0\nexhibit {self.exhibit}\nvessel moon_jar\nrunning_s 60\nsaid {now}\nopen true\nvisitor %s\n"
                 "wakes 60000\nframes_a_second 60\nend\n")

        def says(board, visitor):
            board.seek(0)
            board.truncate()
            board.write(state % visitor)
            board.flush()
        with self.page() as page, open(self.kept / ".kiosk", "w") as board:
            fcntl.flock(board, fcntl.LOCK_EX)
            says(board, "false")
            self.come_in(page, "settings")
            page.wait("!!document.querySelector('#settings-fields input')", "the form")
            page.tap("#settings-form .see")
            page.wait("document.getElementById('look-words').innerText.includes('draws it')", "it is drawn")
            self.assertNotEqual(drawers(self.folder), [])
            says(board, "true")
            page.wait("document.getElementById('look-words').innerText.includes('A visitor is at the kiosk')", "it is told", ENDED)
            for _ in range(10 * ENDED):
                if not drawers(self.folder):
                    break
                time.sleep(0.1)
            self.assertEqual(drawers(self.folder), [], "it ended at once")
            says(board, "false")
            self.drawn(page)

    def test_who_closes_it_wants_it_no_more(self):
        with self.page() as page:
            self.come_in(page, "settings")
            page.wait("!!document.querySelector('#settings-fields input')", "the form")
            page.tap("#settings-form .see")
            page.wait("document.getElementById('look-words').innerText.includes('draws it')", "it is drawn")
            page.tap("#look-close")
            for _ in range(10 * ENDED):
                if not drawers(self.folder):
                    break
                time.sleep(0.1)
            self.assertEqual(drawers(self.folder), [])


if __name__ == "__main__":
    staff_site.main()
