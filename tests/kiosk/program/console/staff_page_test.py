"""The staff's page in a real browser: coming in, each part on a desk's screen, a tablet and a phone, light and dark;
finding, printing, a pass for a phone, deleting; files with a slip; the program gone.

usage: staff_page_test.py --console build/.../onggi-console --onggi build/.../onggi [--every] [--pictures DIR]
Skipped (77) where there is no chromium.
"""
import fcntl
import itertools
import re
import subprocess
import time

import staff_site
from staff_site import JAR, OLLA, SIZES, browsers

SHOWN = [part for part in staff_site.PARTS if part != "people"]


class StaffPage(staff_site.StaffSite):
    def test_every_part_on_every_screen_light_and_dark(self):
        with self.page() as page:
            page.go(self.way_in)
            page.wait("!!document.querySelector('#lines li')", "the state")
            self.assertNotIn("code=", page.value("location.href"))
            self.assertEqual(self.text(page, "#title"), "Make a pot")
            self.assertIn("does not run", self.text(page, "#lines"))
            cookie = page.say("Network.getCookies")["cookies"][0]
            self.assertTrue(cookie["httpOnly"] and cookie["sameSite"] == "Strict")
        every = list(itertools.product(SHOWN, SIZES, (False, True)))
        some = [(part, list(SIZES)[n % 3], n % 2 == 1) for n, part in enumerate(SHOWN)] + [("desk", "phone", True)]
        for part, size, dark in every if staff_site.ARGUMENTS.every else some:
            if part == "files" and not staff_site.checks():
                continue
            with self.page(size, dark=dark) as page:
                page.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)
                self.open(page, part)
                if part == "desk":
                    page.value("document.getElementById('day').value = ''")
                    page.tap("#find button")
                    page.wait("document.querySelectorAll('#pots li').length === 2", "both keepsakes")
                self.looked_at(page, f"{part}_{size}_{'dark' if dark else 'light'}")

    def test_who_comes_without_the_code_or_twice_with_it_stays_outside(self):
        with self.page("phone") as page:
            page.go(self.at)
            page.wait("document.getElementById('other').open", "how to come in")
            self.assertIn("sudo onggi setup --code", self.text(page, "main"))
            # The browser tells the console that this page is a 401; the page itself is whole.
            self.assertEqual([c for c in page.complaints() if "401" not in c], [])
        with self.page() as page:
            page.go(self.way_in)
            page.wait("!!document.querySelector('#lines li')")
        with self.page() as page:
            page.go(self.way_in)
            page.wait("document.getElementById('said').innerText.includes('not good any more')", "why not")
            page.wait("document.getElementById('other').open", "how to come in")
            self.assertIn("behind this page", self.text(page, "main"))

    def test_the_desk_finds_prints_gives_a_pass_and_deletes(self):
        with self.exhibit.open("a") as file:
            file.write('\n[phone]\naddress = "http://192.168.4.1:8080"\n')
        (self.kept / "phone").mkdir()
        (self.kept / "phone/.served").touch()  # as the program for phones does
        with self.page() as page:
            page.go(self.way_in)
            page.wait("!!document.querySelector('#lines li')")
            page.value("location.hash = '#desk'")
            page.wait("document.querySelector('#found').innerText.includes('Today: nothing was kept.')")
            page.value("document.getElementById('name').value = 'Heron'")
            page.tap("#find button")
            page.wait("document.querySelectorAll('#pots li').length === 1", "the heron")
            page.tap("#pots button")
            page.wait("document.getElementById('pot').open")
            self.assertEqual(self.text(page, "#pot-title"), "quiet blue heron")
            page.wait("document.querySelector('#pot-pictures img').naturalWidth > 0", "its postcard")
            page.tap("#pot-pass")
            page.wait("!!document.querySelector('#pot-code path')", "the code")
            self.assertIn("http://192.168.4.1:8080/k/", self.text(page, "#pot-code"))
            self.looked_at(page, "pass")
            with self.page() as other:
                cookie = page.say("Network.getCookies")["cookies"][0]
                other.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)
                other.say("Page.addScriptToEvaluateOnNewDocument", source="window.print = () => { window.printed = true; }")
                other.go(self.at + "/print/" + JAR)
                other.wait("window.printed", "the browser's print")
                self.assertEqual(other.complaints(), [])
            page.tap("#pot-delete")
            page.wait("!document.getElementById('pot-sure').hidden")
            page.tap("#pot-no")
            self.assertTrue((self.kept / JAR).is_dir())
            page.tap("#pot-delete")
            page.tap("#pot-yes")
            page.wait("!document.getElementById('pot').open", "it is deleted")
            page.wait("document.querySelector('#found').innerText.startsWith('Deleted: quiet blue heron.')")
            self.assertFalse((self.kept / JAR).exists())
            self.assertTrue((self.kept / OLLA).is_dir())
            self.assertEqual(page.complaints(), [])

    def test_a_slip_in_a_file_is_said_with_its_line_and_gone_when_it_is_mended(self):
        if not staff_site.checks():
            self.skipTest("onggi is not built here, and the page asks it")
        good = self.exhibit.read_text()
        self.exhibit.write_text(good.replace("warn_after = 60 ", "warn_after = -5 "))
        with self.page("tablet") as page:
            page.go(self.way_in)
            page.wait("!!document.querySelector('#lines li')")
            page.value("location.hash = '#files'")
            page.wait("!!document.querySelector('#problems .wrong')", "the slip", patience=60)
            self.assertIn("exhibit.toml, line ", self.text(page, "#problems"))
            self.looked_at(page, "slip")
            self.exhibit.write_text(good)
            page.wait("!document.querySelector('#problems .wrong') && !!document.querySelector('#files-list li')",
                      "mended", patience=60)

    def test_the_kiosk_is_seen_to_run_and_to_be_gone_and_the_program_too(self):
        now = int(time.time())
        state = (f"version 0.1.0\nexhibit {self.exhibit}\nvessel moon_jar\nrunning_s 60\nsaid {now}\nopen true\n"
                 "wakes 60000\nframes_a_second 60\nend\n")
        with self.page() as page, open(self.kept / ".kiosk", "w") as board:
            fcntl.flock(board, fcntl.LOCK_EX)
            board.write(state)
            board.flush()
            page.go(self.way_in)
            page.wait("document.querySelector('#lines').innerText.includes('with the moon jar on the wheel')", "it runs")
            self.looked_at(page, "console")
            fcntl.flock(board, fcntl.LOCK_UN)
            page.wait("document.querySelector('#lines').innerText.includes('stopped without being closed')", "it crashed")
            self.console.terminate()
            page.wait("!document.getElementById('lost').hidden", "the program is gone")
            self.assertIn("start onggi-console again", self.text(page, "#lost"))

    def test_the_first_editor_comes_by_a_code_and_gives_the_desk_a_name(self):
        def write(page, **values):
            for name, value in values.items():
                page.value(f"document.getElementById({name.replace('_', '-')!r}).value = {value!r}")

        def add(page, name, role):
            write(page, person_name=name, person_role=role, person_passphrase=f"the passphrase of {name}")
            page.tap("#person button")
            page.wait(f"document.querySelector('#people-list').innerText.includes({name!r})", name)

        def enter(page, name, passphrase):
            write(page, name=name, passphrase=passphrase)
            page.tap("#enter button")

        with self.page() as page:
            page.go(self.way_in)
            page.wait("!!document.querySelector('#lines li')")
            page.value("location.hash = '#people'")
            page.wait("document.querySelector('#people-words').innerText.includes('Nobody has a name yet')")
            self.assertEqual(page.value("document.getElementById('person-role').value"), "editor")
            write(page, person_name="joon", person_passphrase="short")
            page.tap("#person button")
            page.wait("document.querySelector('#people-words').innerText.includes('too short')")
            add(page, "joon", "editor")
            add(page, "maria", "desk")
            page.value("document.getElementById('changes').open = true")
            page.wait("document.querySelector('#changes-list').innerText.includes('maria (desk)')")
            self.assertEqual(page.value(browsers.LAYOUT)["found"], [])
        with self.page("phone") as page:
            page.go(self.at)
            page.wait("!document.getElementById('enter').hidden && !document.getElementById('other').open", "to sign in")
            self.assertEqual(page.value(browsers.LAYOUT)["found"], [])
            enter(page, "maria", "the passphrase of joon")
            page.wait("document.getElementById('said').innerText.includes('do not belong together')")
            time.sleep(1.1)
            enter(page, "Maria", "the passphrase of maria")
            page.wait("!!document.querySelector('#lines li')", "maria is in")
            self.assertEqual(self.text(page, "#who"), "maria")
            self.assertTrue(page.value("document.querySelector(\"nav a[href='#people']\").hidden"))
            page.tap("#own")
            write(page, passphrase_old="the passphrase of maria", passphrase_new="my own passphrase")
            page.tap("#passphrase-form button")
            page.wait("document.getElementById('passphrase-words').innerText === 'It is changed.'", "it is changed")
            page.tap("#passphrase-close")
            page.tap("#leave")
            page.wait("!!document.getElementById('enter')", "she is out")
            page.wait("!document.getElementById('enter').hidden")
            enter(page, "maria", "my own passphrase")
            page.wait("!!document.querySelector('#lines li')", "maria is in again")
        code = re.search(r"/\?code=\w+", subprocess.run([*self.site, "--code"], capture_output=True, text=True).stdout)[0]
        with self.page() as page:
            page.go(self.at + code)
            page.wait("!!document.querySelector('#lines li')", "in by another code")
            page.value("location.hash = '#people'")
            page.wait("document.querySelectorAll('#people-list li').length === 2")
            page.tap("#people-list li:nth-child(2) .danger")
            page.tap("#people-list li:nth-child(2) .danger")
            page.wait("document.querySelectorAll('#people-list li').length === 1", "maria is removed")

    def test_by_keys_alone(self):
        with self.page() as page:
            page.go(self.way_in)
            page.wait("!!document.querySelector('#lines li')")

            def press(key, code=None, text=None):
                for kind in ("keyDown", "keyUp"):
                    page.say("Input.dispatchKeyEvent", type=kind, key=key, code=code or key,
                             **({"text": text} if text and kind == "keyDown" else {}))
            for _ in range(12):
                press("Tab")
                if page.value("document.activeElement.hash") == "#desk":
                    break
            press("Enter", text="\r")
            page.wait("!document.querySelector('[data-part=desk]').hidden", "the desk")
            self.assertEqual(page.value("document.activeElement.id"), "content")


if __name__ == "__main__":
    staff_site.main()
