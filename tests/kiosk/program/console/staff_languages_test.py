"""The staff's page speaks the reader's language, and every text of it does.

usage: staff_languages_test.py --console build/.../onggi-console --onggi build/.../onggi
Skipped (77) where there is no chromium.
"""
import json
import os
import pathlib
import shutil

import staff_site
import staff_words

# What stands on the page in no language of the page's own: names, figures and files of the exhibit, and units.
DATA = ["Onggi", "Make a pot", "Moon jar", "moon jar", "moon_jar", "olla", "quiet blue heron", "maria.k", "joon", "config/", "content/", "2026-05-28"]
UNITS = {"mm", "MB", "m", "m/s", "rad/s", "rad/s²", "Pa", "Pa s", "J", "kg/m³", "m²/s", "N/m per m²"}
# The texts on the screen that are not in brackets, but for those of a label, a mission and the kiosk.
BARE = """[...document.querySelectorAll("body :not(script, noscript, code, textarea, .card *, #list-body legend, #words-body .field *)")].filter((e) => e.checkVisibility() && !e.closest("[lang]:not(html)"))
  .flatMap((e) => [...e.childNodes]).filter((n) => n.nodeType === 3 && /[A-Za-z]{2}/.test(n.data) && !n.data.includes("⟦")).map((n) => n.data.trim())"""


class StaffLanguages(staff_site.StaffSite):
    def setUp(self):
        if not staff_site.checks():
            self.skipTest("onggi is not built here, and the page asks it")
        # A language in which every text of the page is known by its brackets, for a copy of the program.
        self.programs = pathlib.Path(staff_site.tempfile.mkdtemp(prefix="onggi-languages-"))
        shutil.copy(staff_site.ARGUMENTS.console, self.programs / "onggi-console")
        os.symlink(os.path.abspath(staff_site.ARGUMENTS.onggi), self.programs / "onggi")
        shutil.copytree(staff_site.ROOT / "content/staff", self.programs / "content/staff")
        words = staff_words.texts(staff_site.ARGUMENTS.onggi)
        table = lambda editors: "".join(f"{json.dumps(text, ensure_ascii=False)} = {json.dumps(f'⟦{text}⟧', ensure_ascii=False)}\n" for text, of in words.items() if of == editors)
        (self.programs / "content/staff/xx.toml").write_text(f'name = "Brackets"\nright_to_left = false\n[page]\n{table(False)}[editors]\n{table(True)}')
        self.given = staff_site.ARGUMENTS.console
        staff_site.ARGUMENTS.console = str(self.programs / "onggi-console")
        super().setUp()

    def tearDown(self):
        super().tearDown()
        staff_site.ARGUMENTS.console = self.given
        shutil.rmtree(self.programs)

    def test_no_text_of_the_page_is_left_in_english(self):
        found = {}
        with self.page(before=self.speaking("xx")) as page:
            page.go(self.at)  # the door
            page.wait("document.documentElement.lang === 'xx'", "the language of brackets")
            found["door"] = page.value(BARE)
            self.come_in(page)
            for name in (name for name in staff_site.PAGES if name != "passphrase"):  # who came by a code has none
                page.go("about:blank")
                self.show(page, name)
                page.wait("typeof loaded !== 'undefined' && loaded", "the words of editors")
                found[name] = page.value(BARE)
        names = page_languages()
        left = {name: [text for text in dict.fromkeys(texts) if text not in UNITS | names and not any(data in text for data in DATA)] for name, texts in found.items()}
        self.assertEqual({name: texts for name, texts in left.items() if texts}, {})

    def test_the_browsers_language_is_spoken_and_another_one_is_remembered(self):
        words = staff_words.tomllib.loads((staff_site.ROOT / "content/staff/ko.toml").read_text())
        with self.page(before=self.speaking("ko-KR")) as page:
            self.come_in(page, "settings")
            self.assertEqual(page.value("[document.documentElement.lang, document.documentElement.dir]"), ["ko", "ltr"])
            self.assertEqual(self.text(page, "#leave"), words["page"]["Sign out"])
            self.assertEqual(self.text(page, "#settings-save"), words["editors"]["Save"])

            def choose(code, leave):
                page.arriving(lambda: page.value(f"(() => {{ const e = document.getElementById('speak'); e.value = {code!r}; e.dispatchEvent(new Event('change')); }})()"), code)
                page.wait(f"document.getElementById('leave').innerText === {leave!r} && !!document.querySelector('#lines li')", code)

            arabic = staff_words.tomllib.loads((staff_site.ROOT / "content/staff/ar.toml").read_text())
            choose("ar", arabic["page"]["Sign out"])
            self.assertEqual(page.value("[document.documentElement.lang, document.documentElement.dir]"), ["ar", "rtl"])
            choose("en", "Sign out")
            page.go(self.at)  # it is remembered
            page.wait("!!document.querySelector('#lines li')", "the state")
            self.assertEqual(page.value("document.documentElement.lang"), "en")
        with self.page(before=self.speaking("nl")) as page:  # there is none: English
            page.go(self.at)
            page.wait("!document.getElementById('speak').hidden", "the door")
            self.assertEqual(page.value("document.documentElement.lang"), "en")

    def test_a_language_is_chosen_after_what_is_typed_is_saved(self):
        with self.page(before=self.speaking("ko")) as page:
            self.come_in(page, "settings")
            page.wait("loaded && document.querySelector('#settings-fields input') !== null", "the form")
            page.value("(() => { const e = document.querySelector('#settings-fields input'); e.value = 'Kim'; e.dispatchEvent(new Event('input')); })()")
            page.value("(() => { const e = document.getElementById('speak'); e.value = 'de'; e.dispatchEvent(new Event('change')); })()")
            self.assertEqual(page.value("[document.getElementById('speak').value, localStorage.getItem('language'), document.documentElement.lang]"), ["ko", None, "ko"])
            self.assertEqual(self.text(page, "#settings-words"), page.value("saveFirst"))
            self.assertEqual(page.value("document.querySelector('#settings-fields input').value"), "Kim")

    def test_people_and_vessels_are_called_as_they_are(self):
        with self.page(before=self.speaking("ko")) as page:
            self.come_in(page, "people")
            for field, value in (("name", "wire"), ("role", "editor"), ("passphrase", "the passphrase of wire")):
                page.value(f"document.getElementById('person-{field}').value = {value!r}")
            page.tap("#person button")
            page.wait("document.querySelector('#people-list').innerText.includes('wire')", "somebody called as a tool is")
            cookie = page.say("Network.getCookies")["cookies"][0]
            with self.page(before=self.speaking("ko")) as again:  # its list is drawn before the words of editors come
                again.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)
                self.open(again, "people")
                again.wait("typeof loaded !== 'undefined' && loaded && !!document.querySelector('#people-list h3')", "the list")
                self.assertEqual(self.text(again, "#people-list h3"), "wire")
            page.value("location.hash = '#desk'")
            page.value("document.getElementById('day').value = ''; document.getElementById('name').value = '달항아리'")
            page.tap("#find button")
            page.wait("document.querySelectorAll('#pots li').length === 1", "the moon jar, by what its label calls it")
            self.assertIn("달항아리", self.text(page, "#pots li"))

    def test_where_nothing_answers_the_door_says_so(self):
        before = self.speaking("ko") + "const real = window.fetch; window.fetch = (at, ...rest) => String(at) === '/api/door' ? Promise.reject(new Error('gone')) : real(at, ...rest);"
        with self.page(before=before) as page:
            page.go(self.at)
            page.wait("document.getElementById('said').innerText !== ''", "why there is no door")
            self.assertTrue(page.value("document.getElementById('enter').hidden"))

    def test_a_fault_of_the_program_is_one_english_sentence_on_a_page_from_right_to_left(self):
        with self.page(before=self.speaking("ar")) as page:
            self.come_in(page, "settings")
            page.wait("loaded", "the words of editors")
            page.value("tell(document.getElementById('settings-words'), refusal({ what: 'It is odd.', remedy: 'Make it even.' }))")
            self.assertEqual(page.value("document.querySelector('#settings-words > [lang=en][dir=ltr]').innerText"), "It is odd. Make it even.")

    def test_hours_and_numbers_are_taken_as_people_write_them(self):
        hours, number = "{ kind: 'text', table: 'hours', allowed: '' }", "{ kind: 'number', table: 'idle', allowed: '' }"
        with self.page(before=self.speaking("de")) as page:
            self.come_in(page, "settings")
            page.wait("typeof loaded !== 'undefined' && loaded", "the forms")
            for words, field, wanted in (("10-18 Uhr", hours, "10:00-18:00"), ("9:00 – 12:30, 14-18", hours, "09:00-12:30, 14:00-18:00"), ("Geschlossen", hours, "closed"),
                                         ("closed", hours, "closed"), ("١٠:٠٠-١٨:٠٠", hours, "10:00-18:00"), ("٠٫٧", number, 0.7), ("0,7", number, 0.7), ("soon", number, "soon")):
                self.assertEqual(page.value(f"typed({words!r}, {field})"), wanted)

    def test_common_faults_are_said_in_the_pages_language(self):
        words = staff_words.tomllib.loads((staff_site.ROOT / "content/staff/ko.toml").read_text())["editors"]
        with self.page(before=self.speaking("ko")) as page:
            self.come_in(page, "settings")
            page.wait("loaded && document.getElementById('field-exhibit-idle-warn_after') !== null", "the form")
            for typed, key, values in (("5", "{value} is too little: at least {least}.", {"value": "5 s", "least": "20 s"}),
                                       ("9999", "{value} is too much: at most {most}.", {"value": "9999 s", "most": "3600 s"}),
                                       ("soon", "“{value}” is no number.", {"value": "soon"})):
                page.value(f"(() => {{ const e = document.getElementById('field-exhibit-idle-warn_after'); e.value = {typed!r}; e.dispatchEvent(new Event('input')); }})()")
                wanted = words[key].format(**values)
                page.wait(f"document.getElementById('field-exhibit-idle-warn_after-fault').innerText === {wanted!r}", wanted)

    def test_numbers_have_the_forms_of_their_language(self):
        with self.page(before=self.speaking("ar")) as page:
            self.come_in(page)
            days = [page.value(f"tn({count}, 'one day', '{{count}} days')") for count in (1, 2, 3, 11)]
        self.assertEqual(len(set(days)), 4, days)

    def test_without_the_languages_the_page_speaks_english(self):
        before = self.speaking("ko") + "const real = window.fetch; window.fetch = (at, ...rest) => String(at).startsWith('/words') ? Promise.reject(new Error('gone')) : real(at, ...rest);"
        with self.page(before=before) as page:
            self.come_in(page, "settings")
            self.assertEqual(self.text(page, "#leave"), "Sign out")
            self.assertEqual(self.text(page, "#settings-save"), "Save")


def page_languages():
    """What languages are called by Intl.DisplayNames, which knows nothing of brackets, and by their own files."""
    own = {staff_words.tomllib.loads(file.read_text())["name"] for file in (staff_site.ROOT / "content/staff").glob("*.toml")}
    return own | {"English", "Brackets", "Korean", "Arabic", "German", "Spanish", "French", "Japanese", "Chinese"}


if __name__ == "__main__":
    staff_site.main()
