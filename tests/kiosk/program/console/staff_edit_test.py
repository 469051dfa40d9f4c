"""Changing an exhibit on the staff's page, in a real browser: a value that is wrong and then right, a language, an exception,
the shelf by arrows, by dragging and hidden, a label beside another language's, somebody else's change meanwhile, and undo.

usage: staff_edit_test.py --console build/.../onggi-console --onggi build/.../onggi [--pictures DIR]
Skipped (77) where there is no chromium.
"""
import shutil
import sys
import time
import tomllib

import staff_site
from staff_site import ROOT

PATIENCE = 90  # s: the whole exhibit is looked at before a change is written


class StaffEdit(staff_site.StaffSite):
    def setUp(self):
        if not staff_site.checks():
            self.skipTest("onggi is not built here, and the page lets it write")
        super().setUp()
        for vessel in ("olla", "tea_bowl"):
            shutil.copytree(ROOT / "content/vessels" / vessel, self.folder / "content/vessels" / vessel)

    def values(self, name="config/exhibit.toml"):
        return tomllib.loads((self.folder / name).read_text())

    def type(self, page, key, value, file="exhibit"):
        page.value(f"""(() => {{ const i = document.getElementById("field-{file}-{key}");
            i.value = {value!r}; i.dispatchEvent(new Event("input", {{bubbles: true}})); }})()""")

    def fault(self, key, file="exhibit"):
        return f"document.getElementById('field-{file}-{key}-fault').innerText"

    def save(self, page, form="settings"):
        page.wait(f"!document.getElementById('{form}-save').disabled", "it can be saved")
        page.tap(f"#{form}-save")
        page.wait(f"document.getElementById('{form}-words').innerText.startsWith('Saved')", "saved", PATIENCE)

    def test_a_value_is_refused_at_its_field_then_saved_and_taken_back(self):
        before = self.exhibit.read_text()
        with self.page() as page:
            self.come_in(page, "settings")
            self.type(page, "idle-warn_after", "5")
            page.wait(self.fault("idle-warn_after") + ".includes('the smallest allowed value is 20 s')", "the fault")
            self.assertTrue(page.value("document.getElementById('settings-save').disabled"))
            self.looked_at(page, "fault")
            self.seen(page, "console_settings", "#field-exhibit-idle-warn_after")
            self.type(page, "idle-warn_after", "90")
            page.wait(self.fault("idle-warn_after") + " === ''", "it is right")
            self.type(page, "credit", 'Museum of "Clay"')
            self.save(page)
            self.assertEqual(self.values()["idle"]["warn_after"], 90)
            self.assertEqual(self.values()["credit"], 'Museum of "Clay"')
            self.assertEqual(len(self.exhibit.read_text().splitlines()), len(before.splitlines()))
            page.wait("document.getElementById('undo-what').innerText.includes('60 -> 90')", "what can be taken back")
            page.tap("#undo")
            page.wait("document.getElementById('undo-words').innerText.startsWith('Taken back')", "taken back", PATIENCE)
            self.assertEqual(self.exhibit.read_text(), before)
            self.assertEqual(page.value("document.getElementById('field-exhibit-idle-warn_after').value"), "60")
            page.value("location.hash = '#people'")
            page.value("document.getElementById('changes').open = true")
            page.wait("document.getElementById('changes-list').innerText.includes('idle.warn_after is 90 now')", "who did it")
            self.assertEqual(page.complaints(), [])

    def test_a_language_asks_for_its_title_and_a_day_for_its_hours(self):
        with self.page("tablet") as page:
            self.come_in(page, "settings")
            page.tap("#language-fr")
            page.wait(self.fault("title-fr") + ".includes('There is no title')", "no title yet")
            self.looked_at(page, "language")
            self.type(page, "title-fr", "Faites un pot")
            page.wait(self.fault("title-fr") + " === ''", "it has one")
            page.tap("#language-ko")
            page.tap("[data-id=fr] [data-way=up]")
            self.type(page, "hours-monday", "closed")
            page.wait(self.fault("hours-every_day") + ".includes('no hours')", "the other days")
            page.tap("#settings-words button")
            page.wait("document.activeElement.id === 'field-exhibit-hours-every_day'", "the way there")
            self.type(page, "hours-monday", "")
            self.type(page, "hours-every_day", "9:00 – 18:00")
            page.value("document.getElementById('exception-day').value = 'Christmas'")
            page.tap("#exception-day + button")
            page.wait("document.querySelector('#settings-fields').innerText.includes('Write year, month and day')", "no date")
            page.value("document.getElementById('exception-day').value = '25.12.'")
            page.tap("#exception-day + button")
            page.wait("!!document.getElementById('field-exhibit-hours-exceptions-12-25')", "the day is there")
            self.save(page)
            values = self.values()
            self.assertEqual(values["languages"], ["fr", "en"])
            self.assertEqual(values["title"], {"en": "Make a pot", "fr": "Faites un pot"})
            self.assertEqual(values["hours"], {"every_day": "09:00-18:00", "exceptions": {"12-25": "closed"}})
            self.type(page, "hours-every_day", "")
            self.type(page, "hours-exceptions-12-25", "")
            self.save(page)
            self.assertNotIn("hours", self.values())

    def test_somebody_elses_change_is_shown_and_nobodys_is_lost(self):
        with self.page() as page:
            self.come_in(page, "settings")
            self.type(page, "idle-warn_after", "90")
            self.type(page, "idle-countdown", "40")
            page.wait("!document.getElementById('settings-save').disabled", "it can be saved")
            self.exhibit.write_text(self.exhibit.read_text().replace("warn_after = 60 ", "warn_after = 70 ")
                                    .replace("result_after = 120 ", "result_after = 130 "))
            page.tap("#settings-save")
            page.wait("document.getElementById('settings-words').innerText.includes('Somebody else')", "it is told")
            self.assertTrue(page.value("document.getElementById('settings-save').disabled"), "one of both is chosen first")
            self.assertEqual(self.values()["idle"], {"warn_after": 70, "countdown": 25, "result_after": 130})
            self.assertIn("Theirs: 70", self.text(page, "#settings-fields"))
            self.assertEqual(page.value("document.getElementById('field-exhibit-idle-warn_after').value"), "90")
            self.assertEqual(page.value("document.getElementById('field-exhibit-idle-result_after').value"), "130")
            self.looked_at(page, "meanwhile", but="412")
            page.tap(".theirs button")
            page.wait("document.getElementById('field-exhibit-idle-warn_after').value === '70'", "theirs")
            self.save(page)
            self.assertEqual(self.values()["idle"], {"warn_after": 70, "countdown": 40, "result_after": 130})

    def test_the_shelf_is_ordered_by_arrows_and_by_dragging_and_a_vessel_hidden(self):
        with self.page() as page:
            self.come_in(page, "shelf")
            ids = "[...document.querySelectorAll('#shelf-list li')].map((item) => item.dataset.id)"
            self.assertEqual(page.value(ids), ["moon_jar", "olla", "tea_bowl"])
            page.tap("[data-id=tea_bowl] [data-way=up]")
            self.assertEqual(page.value(ids), ["moon_jar", "tea_bowl", "olla"])
            page.tap("#seen-olla")
            self.drag(page, "[data-id=tea_bowl] .grip", "[data-id=moon_jar] .grip")
            page.wait(f"{ids}[0] === 'tea_bowl'", "it was dragged")
            self.save(page, "shelf")
            self.assertEqual(self.values()["order"], ["tea_bowl"])
            self.assertEqual(self.values()["hidden"], ["olla"])
            self.assertTrue((self.folder / "content/vessels/olla").is_dir())
            self.looked_at(page, "shelf_saved")

    def test_two_who_hide_a_vessel_each_choose_and_what_is_typed_while_it_saves_stays(self):
        with self.page() as page:
            self.come_in(page, "shelf")
            page.tap("#seen-olla")
            self.exhibit.write_text(self.exhibit.read_text().replace("hidden = []", 'hidden = ["tea_bowl"]'))
            page.tap("#shelf-save")
            page.wait("document.getElementById('shelf-words').innerText.includes('Theirs: tea_bowl')", "both are told")
            self.assertTrue(page.value("document.getElementById('shelf-save').disabled"))
            self.assertEqual(self.values()["hidden"], ["tea_bowl"])
            page.tap("#shelf-words .theirs button")
            page.wait("!document.getElementById('seen-tea_bowl').checked && document.getElementById('seen-olla').checked", "theirs")
            page.tap("#seen-olla")
            page.wait("!document.getElementById('shelf-save').disabled", "it can be saved")
            page.tap("#shelf-save")
            page.tap("[data-id=tea_bowl] [data-way=up]")  # while it is saved
            page.wait("document.getElementById('shelf-words').innerText.startsWith('Saved')", "saved", PATIENCE)
            self.assertEqual(sorted(self.values()["hidden"]), ["olla", "tea_bowl"])
            page.wait("!document.getElementById('shelf-save').disabled", "the order is still to be saved")
            page.tap("#shelf-save")
            page.browser.until(lambda: self.values()["order"] == ["moon_jar", "tea_bowl"], "the order is saved too", PATIENCE)
            page.wait("document.getElementById('shelf-save').disabled", "nothing is left", PATIENCE)
            ids = "[...document.querySelectorAll('#shelf-list li')].map((item) => item.dataset.id)"
            self.assertEqual(page.value(ids), ["moon_jar", "tea_bowl", "olla"])

    def test_what_was_typed_stays_when_the_session_is_over(self):
        with self.page() as page:
            self.come_in(page, "settings")
            self.type(page, "credit", "Clay")
            page.value("fetch('/api/leave', {method: 'POST', headers: {'Content-Type': 'application/json'}, body: '{}'})"
                       ".then((answer) => answer.status)")
            page.wait("document.getElementById('lost').innerText.includes('what you typed is still here')", "it is told")
            self.assertEqual(page.value("document.getElementById('field-exhibit-credit').value"), "Clay")

    def test_taking_back_is_of_the_change_that_is_shown_and_tells_what_was_done(self):
        with self.page() as page:
            self.come_in(page, "settings")
            self.type(page, "idle-warn_after", "90")
            self.save(page)
            page.wait("document.getElementById('undo-what').innerText.includes('60 -> 90')", "the newest")
            with self.page() as other:
                self.cookie_to(page, other)
                other.go(self.at + "/#settings")
                other.wait("!!document.getElementById('field-exhibit-sound-volume')", "another editor")
                self.type(other, "sound-volume", "0,25")
                self.save(other)
            page.tap("#undo")
            page.wait("document.getElementById('undo-words').innerText.includes('Another change was made')", "refused", PATIENCE)
            self.assertEqual((self.values()["sound"]["volume"], self.values()["idle"]["warn_after"]), (0.25, 90))
            page.wait("document.getElementById('undo-what').innerText.includes('0.5 -> 0.25')", "the newest now")
            self.exhibit.write_text(self.exhibit.read_text().replace("volume = 0.25", "volume = 0.75"))
            page.tap("#undo")
            page.wait("!document.getElementById('undo-forget').hidden", "a hand has changed it since", PATIENCE)
            page.tap("#undo-forget")
            page.wait("document.getElementById('undo-words').innerText.startsWith('Forgotten')", "forgotten", PATIENCE)
            page.tap("#undo")
            page.wait("document.getElementById('undo-words').innerText.startsWith('Taken back')", "the one before", PATIENCE)
            self.assertEqual((self.values()["sound"]["volume"], self.values()["idle"]["warn_after"]), (0.75, 60))

    def drag(self, page, start, end):
        page.say("Emulation.setTouchEmulationEnabled", enabled=False)
        page.say("Input.setInterceptDrags", enabled=True)
        (x, y), mouse = page.middle(start), dict(button="left", buttons=1, clickCount=1)
        page.say("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, **mouse)
        page.say("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y - 8, **mouse)
        page.browser.until(lambda: page.events("Input.dragIntercepted"), "a drag")
        data = page.events("Input.dragIntercepted")[-1]["data"]
        to_x, to_y = page.middle(end)
        for kind in ("dragEnter", "dragOver", "drop"):
            page.say("Input.dispatchDragEvent", type=kind, x=to_x, y=to_y - 20, data=data)
        page.say("Input.dispatchMouseEvent", type="mouseReleased", x=to_x, y=to_y - 20, **mouse)

    def test_a_label_is_written_beside_another_languages_and_seen_as_a_visitor_will(self):
        with self.page() as page:
            self.come_in(page, "shelf")
            page.tap("[data-id=tea_bowl] button")
            page.wait("!document.getElementById('label').hidden", "the label")
            file = "vessel-tea_bowl"
            self.type(page, "label-ko-title", "다완 하나", file)
            page.wait("document.querySelector('#label-languages [lang=ko].card h4').innerText === '다완 하나'", "as a visitor reads it")
            self.type(page, "label-en-title", "x" * 61, file)
            page.wait(self.fault("label-en-title", file) + " !== ''", "too long")
            self.looked_at(page, "label")
            self.type(page, "label-en-title", "A tea bowl", file)
            page.value("""(() => { const s = document.getElementById('label-beside'); s.value = 'ar';
                s.dispatchEvent(new Event('change', {bubbles: true})); })()""")
            page.wait("!!document.querySelector('#label-languages [lang=ar].card')", "Arabic beside it")
            self.looked_at(page, "label_arabic")
            self.seen(page, "console_label", "#field-vessel-tea_bowl-label-en-text")
            page.tap("#label-close")
            self.assertIn("Save your changes first", self.text(page, "#label-words"))
            self.save(page, "label")
            label = self.values("content/vessels/tea_bowl/vessel.toml")["label"]
            self.assertEqual((label["en"]["title"], label["ko"]["title"]), ("A tea bowl", "다완 하나"))
            page.tap("#label-close")
            page.wait("document.querySelector('[data-id=tea_bowl] h3').innerText === 'A tea bowl'", "on the shelf")

    def test_a_mission_is_switched_on_and_a_glaze_and_a_lesson_reworded(self):
        with self.page("tablet") as page:
            self.come_in(page, "lists")
            page.tap("#field-missions-mission-litre_jar-on")
            self.type(page, "mission-litre_jar-litres", "9", "missions")
            page.wait(self.fault("mission-litre_jar-litres", "missions") + " !== ''", "too much")
            self.type(page, "mission-litre_jar-litres", "1.5", "missions")
            page.value("document.getElementById('list-which').value = 'glazes'")
            page.value("document.getElementById('list-which').dispatchEvent(new Event('change'))")
            self.assertIn("Save your changes first", self.text(page, "#list-words"))
            self.looked_at(page, "missions")
            self.save(page, "list")
            jar = next(one for one in self.values("content/missions.toml")["mission"] if one["id"] == "litre_jar")
            self.assertEqual((jar["on"], jar["litres"]), (True, 1.5))
            for which, file, key, new in (("glazes", "content/glazes.toml", "glaze-celadon-name-ko", "비취"),
                                          ("lesson", "content/lessons/first_minute.toml", "step-open-words-en", "Open it.")):
                page.value(f"document.getElementById('list-which').value = {which!r}")
                page.value("document.getElementById('list-which').dispatchEvent(new Event('change'))")
                page.wait(f"!!document.getElementById('field-{which}-{key}')", which)
                self.looked_at(page, which)
                self.type(page, key, new, which)
                self.save(page, "list")
                self.assertIn(new, (self.folder / file).read_text())

    def test_an_effect_is_switched_on_with_what_it_needs_and_its_price_is_told(self):
        with self.page() as page:
            self.come_in(page, "scenes")
            self.looked_at(page, "scenes")
            page.tap("[data-id=first_touch] button")
            page.wait("document.getElementById('scene-time').innerText.includes('A tick takes')", "what it costs", PATIENCE)
            cost = "document.querySelector('[data-id=%s] .cost').innerText"
            self.assertIn("Would cost", page.value(cost % "propagation"))
            self.assertIn("changes the test’s pot by", page.value(cost % "walls"))
            self.assertIn("costs nothing at the wheel", page.value(cost % "kiln"))
            self.looked_at(page, "scene")
            self.seen(page, "console_scene", "#effect-walls")
            page.tap("#effect-slump")
            self.assertTrue(page.value("document.getElementById('effect-volume').checked"), "slump needs it")
            page.tap("[data-id=slump] summary")
            self.type(page, "slump-yield_stress", "5", "scene-first_touch")
            page.wait(self.fault("slump-yield_stress", "scene-first_touch") + " !== ''", "too soft")
            self.type(page, "slump-yield_stress", "8000", "scene-first_touch")
            page.tap("#effect-volume")
            page.wait("document.querySelector('[data-id=slump]').innerText.includes('Slumping needs “No clay is lost”')", "it cannot be without")
            page.tap("#effect-volume")
            page.wait("document.getElementById('scene-time').innerText.includes('With your changes about')", "what it will cost")
            page.tap("#effect-friction")
            self.save(page, "scene")
            scene = self.values("config/scenes/first_touch.toml")
            self.assertEqual((scene["slump"], scene["volume"], "friction" in scene), ({"yield_stress": 8000}, {}, False))
            page.wait("!document.getElementById('scene-time').innerText.includes('Measuring')", "measured anew", PATIENCE)
            self.assertIn("Costs", page.value(cost % "slump"))
            page.tap("#scene-close")
            page.wait("document.querySelector('[data-id=first_touch]').innerText.includes('A tick takes')", "in the list")
            page.value("""(() => { const s = document.getElementById('field-exhibit-scene'); s.value = 'scenes/studio.toml';
                s.dispatchEvent(new Event('change', {bubbles: true})); })()""")
            self.save(page, "scenes")
            self.assertEqual(self.values()["scene"], "scenes/studio.toml")
            page.wait("document.querySelector('[data-id=studio]').innerText.includes('Visitors throw with it')", "who has it")
            self.assertEqual(page.complaints(), [])

    def test_a_mission_and_a_glaze_are_added_and_taken_out(self):
        with self.page("tablet") as page:
            self.come_in(page, "lists")
            before = (self.folder / "content/missions.toml").read_text()
            page.value("document.getElementById('list-new').value = 'Cup'")
            page.tap("#list-new + button")
            page.wait("document.getElementById('list-body').innerText.includes('Write small Latin letters')", "no name")
            page.value("document.getElementById('list-new').value = 'cup'")
            page.tap("#list-new + button")
            page.wait("!!document.getElementById('field-missions-mission-cup-kind')", "the new one")
            page.wait("document.getElementById('list-words').innerText.includes('need')", "what it lacks")
            self.looked_at(page, "mission_new")
            page.value("""(() => { const s = document.getElementById('field-missions-mission-cup-kind'); s.value = 'describe';
                s.dispatchEvent(new Event('change', {bubbles: true})); })()""")
            page.wait("!!document.getElementById('field-missions-mission-cup-litres')", "the figures of its kind")
            for key, words in (("title-en", "A cup"), ("title-ko", "잔"), ("about-en", "It holds 0.2 litres."), ("about-ko", "0.2리터."), ("litres", "0.2")):
                self.type(page, "mission-cup-" + key, words, "missions")
            self.save(page, "list")
            cup = self.values("content/missions.toml")["mission"][-1]
            self.assertEqual((cup["id"], cup["kind"], cup["title"]["en"], cup["litres"]), ("cup", "describe", "A cup", 0.2))
            page.tap("[aria-label='Take it out: A cup']")
            self.assertIn("It is taken out when you save", self.text(page, "#list-body"))
            self.save(page, "list")
            self.assertEqual((self.folder / "content/missions.toml").read_text(), before)

    def test_words_are_changed_beside_the_english_and_a_place_is_kept(self):
        with self.page() as page:
            self.come_in(page, "words")
            page.tap("#words-body summary")
            page.wait("!!document.querySelector('#words-body input, #words-body textarea')", "its texts")
            self.looked_at(page, "words")
            page.value("""(() => { const s = document.getElementById('words-find'); s.value = 'touch to begin';
                s.dispatchEvent(new Event('input', {bubbles: true})); })()""")
            self.assertIn("Touch to begin", self.text(page, "#words-body"))
            self.type(page, "text-attract-begin", "여기를 누르세요", "language-ko")
            page.value("""(() => { const s = document.getElementById('words-find'); s.value = 'all.list';
                s.dispatchEvent(new Event('input', {bubbles: true})); })()""")
            self.type(page, "text-all-list", "하나", "language-ko")
            page.wait(self.fault("text-all-list", "language-ko") + ".includes('lacks {first}')", "what the program fills in")
            self.looked_at(page, "words_fault")
            self.type(page, "text-all-list", "{first}·{second}", "language-ko")
            self.save(page, "words")
            text = self.values("content/languages/ko.toml")["text"]
            self.assertEqual((text["attract"]["begin"], text["all"]["list"]), ("여기를 누르세요", "{first}·{second}"))

    def test_a_change_is_tried_and_put_back_or_kept(self):
        before = self.exhibit.read_text()
        with self.page() as page:
            self.come_in(page, "settings")
            for value, button in ((90, "back"), (100, "keep")):
                self.type(page, "idle-warn_after", str(value))
                page.wait("!document.querySelector('#settings-save + [value=try]').disabled", "it can be tried")
                page.tap("#settings-save + [value=try]")
                page.wait("document.getElementById('settings-words').innerText.startsWith('It is tried')", "tried", PATIENCE)
                self.assertEqual(self.values()["idle"]["warn_after"], value)
                page.wait("!document.getElementById('trial').hidden && document.getElementById('trial-what').innerText.includes('another 4:')", "how long")
                self.looked_at(page, "trial")
                page.tap("#trial-" + button)
                page.wait("document.getElementById('trial').hidden" if button == "keep" else
                          "document.getElementById('trial-what').innerText === 'The change that was tried has been put back.'", button, PATIENCE)
                if button == "back":
                    page.wait("document.getElementById('field-exhibit-idle-warn_after').value === '60'", "as before", PATIENCE)
                    self.assertEqual(self.exhibit.read_text(), before)
            self.assertEqual(self.values()["idle"]["warn_after"], 100)
            # What is typed while something is tried is saved when that is over, and nobody is blamed.
            self.type(page, "idle-warn_after", "120")
            page.wait("!document.querySelector('#settings-save + [value=try]').disabled", "it can be tried")
            page.tap("#settings-save + [value=try]")
            page.wait("!document.getElementById('trial-back').hidden && !document.getElementById('trial').hidden", "tried", PATIENCE)
            self.type(page, "idle-countdown", "40")
            page.tap("#settings-save")
            page.wait("document.getElementById('settings-words').innerText.startsWith('A change is being tried')", "not now", PATIENCE)
            page.tap("#trial-back")
            page.wait("document.getElementById('trial-back').hidden && document.getElementById('settings-words').innerText === ''", "over", PATIENCE)
            self.assertEqual(page.value("document.getElementById('field-exhibit-idle-countdown').value"), "40")
            self.save(page, "settings")
            self.assertEqual((self.values()["idle"]["warn_after"], self.values()["idle"]["countdown"]), (100, 40))

    def test_the_desk_changes_nothing(self):
        with self.page() as page:
            self.come_in(page, "people")
            for name, role in (("joon", "editor"), ("maria", "desk")):
                for field, value in (("name", name), ("role", role), ("passphrase", "the passphrase of " + name)):
                    page.value(f"document.getElementById('person-{field}').value = {value!r}")
                page.tap("#person button")
                page.wait(f"document.querySelector('#people-list').innerText.includes({name!r})", name)
        with self.page(before=self.speaking("ar")) as page:  # the language with the most letters
            page.go(self.at)
            page.wait("!document.getElementById('enter').hidden", "to sign in")
            for field, value in (("name", "maria"), ("passphrase", "the passphrase of maria")):
                page.value(f"document.getElementById({field!r}).value = {value!r}")
            page.tap("#enter button")
            page.wait("!!document.querySelector('#lines li')", "maria is in")
            self.assertTrue(page.value("document.querySelector(\"nav a[href='#settings']\").hidden"))
            loaded = page.value("""[...performance.getEntriesByType('resource'), ...performance.getEntriesByType('navigation')]
                .map((entry) => [entry.name, entry.decodedBodySize])""")
            self.assertLess(sum(size for _, size in loaded), 100_000, "a first page is light")
            self.assertEqual([name for name, _ in loaded if name.endswith(("/edit.js", "/scan.js"))], [], "editors' own")
            page.value("location.hash = '#settings'")
            time.sleep(0.3)
            self.assertFalse(page.value("document.querySelector('[data-part=now]').hidden"))
            self.assertEqual(page.value("fetch('/api/edit/exhibit').then((answer) => answer.status)"), 403)
            self.assertEqual(page.value("""fetch('/api/undo', {method: 'POST', headers: {'Content-Type': 'application/json'},
                body: '{}'}).then((answer) => answer.status)"""), 403)


if __name__ == "__main__":
    sys.exit(staff_site.main())
