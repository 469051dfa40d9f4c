"""A scan becomes a vessel on the staff's page, in a real browser: files are chosen, what is in doubt is asked by pictures, and the
vessel stands on the shelf with its label open.

usage: staff_scan_test.py --console build/.../onggi-console --onggi build/.../onggi [--pictures DIR]
Skipped (77) where there is no chromium.
"""
import math
import pathlib
import shutil
import sys
import tomllib
import zipfile

import staff_site
from staff_site import ROOT

PATIENCE = 60  # s
OTHERS = ROOT.parent / "shared/vessels"  # other people's scans, read in place


def cup(to, unit=1000.0, lid=False):
    """An OBJ of a cup of 90 mm in `unit` to the metre; with a closed top nobody knows which way up it stands."""
    wall = [(0.0, 0.0), (0.030, 0.0), (0.034, 0.045), (0.036, 0.090)]
    inner = [] if lid else [(0.033, 0.090), (0.031, 0.045), (0.027, 0.004)]
    ring = wall + inner + [(0.0, 0.090 if lid else 0.004)]
    count, lines = 48, []
    for radius, height in ring:
        for n in range(count):
            angle = 2 * math.pi * n / count
            lines.append(f"v {unit * radius * math.cos(angle):.4f} {unit * height:.4f} {unit * radius * math.sin(angle):.4f}")
    for row in range(len(ring) - 1):
        for n in range(count):
            a, b = row * count + n + 1, row * count + (n + 1) % count + 1
            lines.append(f"f {a} {a + count} {b + count} {b}")
    pathlib.Path(to).write_text("\n".join(lines) + "\n")


class StaffScan(staff_site.StaffSite):
    def setUp(self):
        if not staff_site.checks():
            self.skipTest("onggi is not built here, and the page lets it read scans")
        super().setUp()
        self.own = self.folder / "own"
        self.own.mkdir()

    def choose(self, page, *files):
        page.say("DOM.enable")
        root = page.say("DOM.getDocument")["root"]["nodeId"]
        node = page.say("DOM.querySelector", nodeId=root, selector="#scan-files")["nodeId"]
        page.say("DOM.setFileInputFiles", nodeId=node, files=[str(file) for file in files])

    def vessel(self, id):
        return tomllib.loads((self.folder / "content/vessels" / id / "vessel.toml").read_text())

    def test_a_scan_that_is_clear_is_on_the_shelf_after_one_button_and_its_label_opens(self):
        shutil.copy(ROOT / "content/vessels/olla/vessel.glb", self.own / "Kitchen jar.glb")
        with self.page() as page:
            self.come_in(page, "shelf")
            self.choose(page, self.own / "Kitchen jar.glb")
            page.wait("document.getElementById('scan-go')?.disabled === false", "all is known", PATIENCE)
            self.assertEqual(page.value("document.getElementById('scan-id').value"), "kitchen_jar")
            self.assertIn("The inside was measured", self.text(page, "#scan-body"))
            self.looked_at(page, "scan_clear")
            page.tap("#scan-go")
            page.wait("!document.getElementById('label').hidden", "its label", PATIENCE)
            self.assertEqual(page.value("document.getElementById('label-title').textContent"), "Kitchen jar")
            self.looked_at(page, "scan_label")
            self.assertTrue(self.vessel("kitchen_jar")["unfinished"])
            self.assertIn("Still to be written", self.text(page, "#label-languages"))
            self.assertIn("The licence is", self.text(page, "#label-about"))
            page.tap("#label-sheet summary")
            page.wait("document.querySelector('#label-sheet img')?.naturalWidth > 800", "its sheet", PATIENCE)
            self.looked_at(page, "scan_sheet")
            page.tap("#label-close")
            page.wait("document.querySelector('[data-id=kitchen_jar]').innerText.includes('Unfinished')", "on the shelf")
            page.value("location.hash = '#people'")
            page.value("document.getElementById('changes').open = true")
            page.wait("document.getElementById('changes-list').innerText.includes('added vessel: kitchen_jar')", "who did it")
            self.assertEqual(list((self.folder / "state/scans").iterdir()), [])

    def test_what_is_in_doubt_is_chosen_by_pictures(self):
        cup(self.own / "cup.obj", lid=True)
        with self.page("tablet") as page:
            self.come_in(page, "shelf")
            self.choose(page, self.own / "cup.obj")
            page.wait("!!document.getElementById('scan-up-1')", "which way up", PATIENCE)
            self.assertTrue(page.value("document.getElementById('scan-go').disabled"))
            self.looked_at(page, "scan_doubt")
            self.seen(page, "console_scan", "#scan-up-0")
            page.tap("#scan-up-1")
            sizes = page.value("[...document.querySelectorAll('[name=scan-size]')].map((i) => i.parentElement.innerText)")
            self.assertIn("9 cm tall", sizes)
            page.tap(f"#scan-size-{sizes.index('9 cm tall')}")
            page.value("document.getElementById('scan-id').value = 'moon_jar'")
            page.value("document.getElementById('scan-id').dispatchEvent(new Event('input'))")
            self.assertIn("There is a vessel of that name", self.text(page, "#scan-need"))
            page.value("document.getElementById('scan-id').value = 'lidded'")
            page.value("document.getElementById('scan-id').dispatchEvent(new Event('input'))")
            page.tap("#scan-go")
            page.wait("!document.getElementById('label').hidden", "its label", PATIENCE)
            self.assertEqual((self.vessel("lidded")["true_height_mm"], self.vessel("lidded")["up"]), (90.0, "-y"))

    def test_one_of_several_comes_out_of_a_zip_and_what_is_no_scan_is_told(self):
        with zipfile.ZipFile(self.own / "two.zip", "w") as archive:
            for name, lid in (("cup", False), ("bowl", False)):
                cup(self.own / (name + ".obj"), unit=1.0, lid=lid)
                archive.write(self.own / (name + ".obj"), f"set/{name}.obj")
            archive.writestr("__MACOSX/._cup.obj", "x")
        (self.own / "notes.txt").write_text("no scan")
        with self.page("phone") as page:
            self.come_in(page, "shelf")
            self.choose(page, self.own / "notes.txt")
            page.wait("document.getElementById('scan-body').innerText.includes('There is no scan in it')", "no scan", PATIENCE)
            self.looked_at(page, "scan_none")
            self.choose(page, self.own / "two.zip")
            page.wait("!!document.getElementById('scan-which-1')", "which one", PATIENCE)
            page.tap("#scan-which-1")
            self.looked_at(page, "scan_several")
            self.assertTrue(page.value("document.getElementById('scan-go').disabled"), "an OBJ has no unit")
            page.tap("#scan-size-0")
            page.wait("document.getElementById('scan-go')?.disabled === false", "all is known")
            page.tap("#scan-go")
            page.wait("!document.getElementById('label').hidden", "its label", PATIENCE)

    def test_others_scans_are_read_as_they_come(self):
        if not OTHERS.is_dir():
            self.skipTest("other people's scans are not beside this clone")
        with self.page() as page:
            self.come_in(page, "shelf")
            for name, files in (("tea set", [OTHERS / "polyhaven_tea_set_01/tea_set_01_1k.gltf", OTHERS / "polyhaven_tea_set_01/tea_set_01.bin"]),
                                ("teapot", [OTHERS / "sh3d_scopia_teapot.glb"])):
                self.choose(page, *files)
                page.wait("document.querySelector('#scan-body .choice') && document.getElementById('scan-body').innerText.includes('"
                          + ("Which of these" if name == "tea set" else "Which way up") + "')", name, PATIENCE)
                self.looked_at(page, "scan_" + name.replace(" ", "_"))


if __name__ == "__main__":
    sys.exit(staff_site.main())
