#!/usr/bin/env python3
"""What onggi-console says to a wrong command line.

usage: console_main_test.py --console build/.../onggi-console
"""
import argparse
import subprocess
import sys
import unittest

OPTIONS = ("--site", "--address", "--state", "--keepsakes", "--listen", "--languages", "--pass", "--hours", "--stl", "--to")


class CommandLine(unittest.TestCase):
    def said(self, *words):
        run = subprocess.run([ARGUMENTS.console, *words], capture_output=True, text=True, timeout=20)
        self.assertEqual((run.returncode, run.stdout), (2, ""), words)
        return run.stderr

    def test_an_empty_word_is_most_often_an_unset_variable_and_is_refused_by_name(self):
        for option in OPTIONS:
            self.assertEqual(self.said("--stl", "nowhere", option, ""),
                             f"{option}: It is empty.\n  Name something, or leave the option out.\n")

    def test_a_value_that_is_missing_and_an_option_that_does_not_exist_are_told(self):
        for option in OPTIONS:
            self.assertIn(f"{option}: This option needs a value.", self.said(option))
        self.assertIn("--print: This option does not exist.", self.said("--print", "x"))
        self.assertIn("The action is missing.", self.said("--to", "x.stl"))

    def test_an_option_that_the_action_does_not_see_is_refused(self):
        for action, wrong in ((("--pass", "x"), "--keepsakes"), (("--pass", "x"), "--to"), (("--pass", "x"), "--stl"),
                              (("--stl", "x"), "--hours"), (("--stl", "x"), "--listen"),
                              (("--phone-only", "--keepsakes", "x"), "--hours"), (("--site", "x"), "--keepsakes"),
                              (("--site", "x"), "--languages"), (("--phone-only", "--keepsakes", "x"), "--state")):
            self.assertIn(f"{wrong}: It has no effect with {action[0]}.\n",
                          self.said(*action, wrong, "1"))
        self.assertIn("--phone-only: It has no effect with --stl.", self.said("--phone-only", "--stl", "x"))

    def test_the_staffs_page_is_of_an_exhibit_and_for_this_machine_alone(self):
        self.assertIn("There is no exhibit here", self.said("--site", "/nowhere"))
        for address in ("0.0.0.0:8090", "[::]:8090", "192.168.4.1:8090"):
            self.assertIn("The staff's page is for this machine alone", self.said("--site", "x", "--listen", address))

    def test_behind_a_proxy_it_needs_a_socket_and_the_proxys_addresses(self):
        page = "https://192.168.1.20"
        self.assertIn("--address is missing", self.said("--site", "x", "--listen", "unix:/tmp/page.sock"))
        self.assertIn("asks by a Unix socket", self.said("--site", "x", "--address", page))
        self.assertIn("asks by a Unix socket", self.said("--site", "x", "--listen", "127.0.0.1:8090", "--address", page))
        for wrong in ("http://192.168.1.20", "https://", "192.168.1.20"):
            self.assertIn(f"--address {wrong}: This is not", self.said("--site", "x", "--listen", "unix:/tmp/page.sock",
                                                                     "--address", page, "--address", wrong))
        self.assertIn("--address: It has no effect", self.said("--phone-only", "--keepsakes", "x", "--address", page))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--console", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
