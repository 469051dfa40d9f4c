"""What the package promises, held against its files: hardened services that systemd understands, a manual
of every command, licences for all that it brings.

usage: package_test.py --program build/.../onggi --laboratory build/.../onggi-lab
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[4]
PACKAGE = ROOT / "kiosk/program/package"
UNITS = sorted((PACKAGE / "system").glob("*.service"))


def output(*command, **kept):
    return subprocess.run(command, capture_output=True, text=True, check=False, **kept)


class Services(unittest.TestCase):
    def test_each_is_exposed_less_than_3_by_systemds_own_reckoning(self):
        self.assertEqual(len(UNITS), 6)
        for unit in UNITS:
            told = output("systemd-analyze", "security", "--offline=yes", unit).stdout
            exposed = re.search(r"exposure level for \S+: ([0-9.]+)", told)
            self.assertIsNotNone(exposed, unit.name + ": " + told[-200:])
            self.assertLess(float(exposed[1]), 3.0, unit.name)

    def test_systemd_understands_every_line(self):
        # The programs and the manual are not installed here, so that copies name ones that are.
        with tempfile.TemporaryDirectory() as folder:
            for unit in [*UNITS, *(PACKAGE / "system").glob("*.socket")]:
                text = re.sub(r"^ExecStart=.*", "ExecStart=/bin/true", unit.read_text(), flags=re.M)
                text = re.sub(r"^Documentation=.*\n", "", text, flags=re.M)
                (pathlib.Path(folder) / unit.name).write_text(text)
            told = output("systemd-analyze", "verify", "--man=no", "--generators=no",
                          *sorted(str(p) for p in pathlib.Path(folder).iterdir()))
        ours = [line for line in told.stderr.splitlines() if "onggi" in line]
        self.assertEqual(ours, [])
        self.assertEqual(told.returncode, 0, told.stderr)

    def test_a_screen_that_died_brings_the_kiosk_back_with_it(self):
        kiosk, screen = ((PACKAGE / "system" / name).read_text()
                         for name in ("onggi.service", "onggi-display.service"))
        self.assertIn("\nBindsTo=onggi-display.service\n", kiosk)
        self.assertIn("\nUpholds=onggi.service\n", screen)

    def test_each_program_that_a_network_reaches_is_a_user_of_its_own(self):
        users = {}
        for unit in UNITS:
            text = unit.read_text()
            groups = re.search(r"^SupplementaryGroups=(.*)", text, flags=re.M)
            users[unit.stem] = (re.search(r"^User=(.*)", text, flags=re.M)[1], set(groups[1].split()) if groups else set())
        self.assertEqual(users["onggi-phone"], ("onggi-phone", {"onggi-keepsakes"}))
        self.assertEqual(users["onggi-console"], ("onggi-console", {"onggi", "onggi-keepsakes", "onggi-site"}))
        self.assertEqual(users["onggi-staff-web"], ("onggi-staff-web", {"onggi-console"}))
        self.assertEqual(users["onggi-screen@"], ("onggi-screen", {"onggi-site"}))
        self.assertEqual(users["onggi"], ("onggi", {"video", "render", "onggi-keepsakes"}))
        made = (PACKAGE / "system/sysusers.conf").read_text()
        for user, groups in users.values():
            self.assertRegex(made, rf"(?m)^u {user} - ")
            for group in groups:
                if group.startswith("onggi"):
                    self.assertRegex(made, rf"(?m)^[ug] {group} -")

    def test_screens_are_drawn_by_who_writes_nothing_and_only_when_nothing_else_is_done(self):
        screen = (PACKAGE / "system/onggi-screen@.service").read_text()
        self.assertNotIn("ReadWritePaths", screen)
        for line in ("ProtectSystem=strict", "PrivateNetwork=yes", "CPUWeight=idle"):
            self.assertIn(f"\n{line}\n", screen)
        place = re.search(r"^ListenStream=(.*)", (PACKAGE / "system/onggi-screen.socket").read_text(), flags=re.M)[1]
        self.assertIn("--screens " + place, (PACKAGE / "system/onggi-console.service").read_text())

    def test_the_kiosk_may_write_nowhere_but_where_keepsakes_go(self):
        text = (PACKAGE / "system/onggi.service").read_text()
        self.assertIn("ProtectSystem=strict", text)
        self.assertEqual(re.findall(r"^ReadWritePaths=(.*)", text, flags=re.M), ["-/srv/onggi/keepsakes"])


class Manual(unittest.TestCase):
    def setUp(self):
        self.page = output(ARGUMENTS.program, "--manual", "2026-11-22").stdout
        self.laboratory = output(ARGUMENTS.laboratory, "--manual", "2026-11-22").stdout

    def test_it_has_every_command_that_the_program_has(self):
        def commands(program, words):
            told = output(program, *words, "--help").stdout
            below = told.partition("Subcommands:")[2]
            for name in re.findall(r"^  (\S+)", below, flags=re.M):
                yield [*words, name]
                if [*words, name] != ["lab"]:  # which onggi-lab answers
                    yield from commands(program, [*words, name])
        for name, program, page, least in (("onggi", ARGUMENTS.program, self.page, 13),
                                           ("onggi-lab", ARGUMENTS.laboratory, self.laboratory, 9)):
            found = list(commands(program, []))
            self.assertGreater(len(found), least)
            described = [d.replace("\\-", "-") for d in re.findall(r"^\.SS \\fB(.*?)\\fR", page, flags=re.M)]
            for words in found:
                if not any(other[:-1] == words for other in found) and words != ["lab"]:
                    self.assertIn(name + " " + " ".join(words), described)
        self.assertIn(".SS \\fBonggi lab tune\\fR", self.page)

    def test_it_has_every_option_that_help_shows(self):
        for words in (["run"], ["setup"], ["vessel", "inspect"]):
            head = ".SS \\fBonggi " + " ".join(words) + "\\fR"
            self.assertIn(head, self.page)
            own = re.split(r"^\.S[SH] ", self.page[self.page.index(head) + 4:], flags=re.M)[0]
            for option in re.findall(r"^  (?:-\w,)?(--\S+)", output(ARGUMENTS.program, *words, "--help").stdout,
                                     flags=re.M):
                if option != "--help":
                    self.assertTrue(option.replace("-", "\\-") in own, f"{words}: {option}")

    def test_the_formatter_finds_nothing_wrong(self):
        # Where there is groff: man-db's --warnings is its.
        try:
            told = output("groff", "-man", "-Tutf8", "-ww", "-z", "-K", "utf8", input=self.page)
        except FileNotFoundError:
            self.skipTest("groff is not here")
        self.assertEqual(told.stderr, "")


class Papers(unittest.TestCase):
    def test_the_newest_entry_of_the_changelog_is_this_version(self):
        version = re.search(r"project\(onggi VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertTrue((PACKAGE / "changelog").read_text().startswith(f"onggi ({version}) "))

    def test_every_vessels_licence_is_in_the_copyright_file(self):
        papers = (PACKAGE / "copyright").read_text()
        for vessel in (ROOT / "content/vessels").glob("*/vessel.toml"):
            licence = tomllib.loads(vessel.read_text())["licence"]
            self.assertIn(f"License: {licence}\n", papers, vessel)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--laboratory", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
