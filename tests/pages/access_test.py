#!/usr/bin/env python3
"""Holds access.py to its job: the table takes the place of the one before, and nothing else of the page changes."""

import unittest

import access

PAGE = "# Page\n" + access.HEAD + "| old |\n" + access.END + "End\n"


class Table(unittest.TestCase):
    def test_it_takes_the_place_of_the_one_before_and_nothing_else_of_the_page_changes(self):
        once = access.with_table(PAGE, "| new |\n")
        self.assertEqual(once, PAGE.replace("old", "new"))
        self.assertEqual(access.with_table(once, "| new |\n"), once)

    def test_a_page_without_a_place_for_it_is_left_alone(self):
        for page in ("", "# Page\n", access.HEAD, access.END, access.END + access.HEAD):
            with self.assertRaisesRegex(SystemExit, "no place"):
                access.with_table(page, "| new |\n")

    def test_a_report_without_one_never_empties_the_page(self):
        with self.assertRaisesRegex(SystemExit, "no table"):
            access.with_table(PAGE, access.table_in("1920x1080, 600 mm\nscreen  capitals mm\n"))

    def test_it_is_the_lines_of_the_report_that_are_of_a_table(self):
        self.assertEqual(access.table_in("attract 7.4\n\n| display |\n|---|\n| 1 |\n"), "| display |\n|---|\n| 1 |\n")

    def test_the_page_of_the_kiosk_has_a_place_for_it(self):
        with open(access.PAGE, encoding="utf-8") as file:
            self.assertIn("| new |", access.with_table(file.read(), "| new |\n"))


if __name__ == "__main__":
    unittest.main()
