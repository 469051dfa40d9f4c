"""Nobody is kept out of the staff's page: axe-core finds nothing (WCAG 2.2, A and AA), everything is reached by keys alone.

usage: staff_access_test.py --console build/.../onggi-console --onggi build/.../onggi [--every]
Each page once, and in Arabic on a phone; with --every in English, Korean and Arabic on each screen, light and dark, and
enlarged twice. Skipped (77) where there is no chromium, or no axe-core and no network to fetch it.
"""
import itertools
import sys

import axe
import staff_site
from staff_site import SIZES

ENLARGED = {"desk at 200 %": (640, 400), "tablet at 200 %": (410, 590)}  # a browser's zoom: half as many pixels of the page


class StaffAccess(staff_site.StaffSite):
    def setUp(self):
        if not staff_site.checks():
            self.skipTest("onggi is not built here, and the page asks it")
        super().setUp()

    def come_in_again(self, page, cookie):
        page.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)
        self.show(page, "now")

    def named(self):
        """A cookie of somebody with a name, so that all is shown."""
        with self.page() as page:
            self.come_in(page, "people")
            for field, value in (("name", "joon"), ("role", "editor"), ("passphrase", "the passphrase of joon")):
                page.value(f"document.getElementById('person-{field}').value = {value!r}")
            page.tap("#person button")
            page.wait("document.querySelector('#people-list').innerText.includes('joon')", "joon")
        with self.page() as page:
            page.go(self.at)
            page.wait("!document.getElementById('enter').hidden", "to sign in")
            self.assertEqual(axe.faults(page, SCRIPT), [], "the door")
            for field, value in (("name", "joon"), ("passphrase", "the passphrase of joon")):
                page.value(f"document.getElementById({field!r}).value = {value!r}")
            page.tap("#enter button")
            page.wait("!!document.querySelector('#lines li')", "joon is in")
            return page.say("Network.getCookies")["cookies"][0]

    def test_axe_finds_nothing(self):
        cookie = self.named()
        with self.page() as page:  # but it would
            self.come_in_again(page, cookie)
            page.value("document.getElementById('lines').append(document.createElement('input'))")
            self.assertTrue(any(fault.startswith("label: ") for fault in axe.faults(page, SCRIPT)))
        screens = {**SIZES, **ENLARGED}
        every = list(itertools.product(staff_site.PAGES, screens, (False, True), ("en", "ko", "ar")))
        some = [(name, list(screens)[n % 3], n % 2 == 1, "en") for n, name in enumerate(staff_site.PAGES)]
        arabic = [(name, "phone", n % 2 == 0, "ar") for n, name in enumerate(staff_site.PAGES)]
        found = {}
        for name, screen, dark, code in every if staff_site.ARGUMENTS.every else some + arabic:
            view = f"{name}, {screen}, {'dark' if dark else 'light'}, {code}"
            with self.browser.page(*screens[screen], scale=1, dark=dark, before=self.speaking(code)) as page:
                page.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)
                self.show(page, name)
                page.wait(f"document.documentElement.lang === {code!r} && typeof loaded !== 'undefined' && loaded", view)
                if code == "ar":
                    self.looked_at(page, view.replace(", ", "_"))
                if faults := axe.faults(page, SCRIPT):
                    found[view] = faults
        self.assertEqual(found, {})

    def test_everything_is_reached_by_the_tab_key_and_seen_when_it_is(self):
        cookie = self.named()
        for name in staff_site.PAGES if staff_site.ARGUMENTS.every else ("settings", "label", "keepsake", "look", "scene"):
            with self.page() as page:
                page.say("Network.setCookie", name=cookie["name"], value=cookie["value"], url=self.at)
                self.show(page, name)
                page.value("document.activeElement.blur()")
                wanted = page.value(REACHABLE)
                reached, hidden = set(), []
                for _ in range(3 * wanted + 30):  # a date has three places
                    page.say("Input.dispatchKeyEvent", type="keyDown", key="Tab", code="Tab", windowsVirtualKeyCode=9)
                    page.say("Input.dispatchKeyEvent", type="keyUp", key="Tab", code="Tab", windowsVirtualKeyCode=9)
                    number, seen = page.value(FOCUSED)
                    if number is not None:
                        reached.add(number)
                        if not seen:
                            hidden.append(page.value("document.activeElement.outerHTML.slice(0, 120)"))
                    if len(reached) == wanted:
                        break
                missed = page.value(f"window.reachable.filter((e, n) => !e.disabled && !{sorted(reached)}.includes(n)).map((e) => e.outerHTML.slice(0, 120))")
                self.assertEqual((missed, hidden), ([], []), name)


# What the tab key should reach: in the open dialog, else in the whole page; of choices that exclude each other, one.
REACHABLE = """(() => {
  const root = document.querySelector("dialog[open]") ?? document, groups = new Set();
  window.reachable = [...root.querySelectorAll("a[href], button, input, select, textarea, summary, [tabindex='0']")].filter((e) => {
    if (e.disabled || e.tabIndex < 0 || !e.checkVisibility({ visibilityProperty: true })) return false;
    if (e.type !== "radio") return true;
    return !groups.has(e.name) && groups.add(e.name);
  });
  return window.reachable.length;
})()"""
# Which of them has the focus, and whether it can be seen: something of it is on the screen and not behind the bar.
FOCUSED = """(() => {
  const e = document.activeElement, box = e.getBoundingClientRect();
  const one = e.type === "radio" ? window.reachable.find((other) => other.name === e.name && other.type === "radio") : e;
  const number = window.reachable.indexOf(one);
  const seen = [0.1, 0.5, 0.9].some((x) => [0.1, 0.5, 0.9].some((y) => {
    const at = document.elementFromPoint(box.left + x * box.width, box.top + y * box.height);
    return at !== null && (e.contains(at) || at.contains(e) && at !== document.body && at !== document.documentElement);
  }));
  return [number < 0 ? null : number, seen];
})()"""

if __name__ == "__main__":
    SCRIPT = axe.source()
    if SCRIPT is None:
        print("axe-core is not here, and cannot be fetched: " + axe.ADDRESS)
        sys.exit(77)
    staff_site.main()
