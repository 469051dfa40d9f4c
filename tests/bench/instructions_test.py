#!/usr/bin/env python3
"""The comparison of instruction counts with their golden."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import instructions  # noqa: E402

KEY = ("GNU-12.2.0", "x86_64", "Release", "AVX2", "light_touch", "400x360")
OTHER = ("GNU-12.2.0", "x86_64", "Release", "AVX2", "both_hands", "400x360")
CLANG = ("Clang-14.0.6", "x86_64", "Release", "AVX2", "light_touch", "400x360")


class Instructions(unittest.TestCase):
    def test_three_percent_more_is_let_pass_and_a_little_over_is_not(self):
        self.assertEqual(instructions.compare({KEY: 1000}, {KEY: 1030}), ([], []))
        wrong, _ = instructions.compare({KEY: 1000}, {KEY: 1031})
        self.assertEqual(len(wrong), 1)
        self.assertIn("light_touch 400x360: 1000 -> 1031 instructions, 3.1 % more", wrong[0])

    def test_fewer_is_no_fault_and_is_said(self):
        wrong, cheaper = instructions.compare({KEY: 1000}, {KEY: 900})
        self.assertEqual(wrong, [])
        self.assertIn("10.0 % fewer", cheaper[0])

    def test_a_script_that_is_new_or_gone_needs_its_golden_renewed(self):
        wrong, _ = instructions.compare({KEY: 1000}, {KEY: 1000, OTHER: 5})
        self.assertIn("both_hands 400x360: has no golden", wrong[0])
        wrong, _ = instructions.compare({KEY: 1000, OTHER: 5}, {KEY: 1000})
        self.assertIn("was not counted", wrong[0])

    def test_other_compilers_and_vectors_are_not_compared(self):
        scalar = KEY[:3] + ("EMU128",) + KEY[4:]
        self.assertEqual(instructions.compare({CLANG: 10}, {KEY: 1000, scalar: 9000}), ([], []))

    def test_what_is_written_is_read_again_with_every_reason(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "golden.txt")
            reasons = ["# renewed 2026-01-02, GNU-12.2.0: first\n", "# renewed 2026-01-03, x: more\n"]
            instructions.write(path, {KEY: 12, CLANG: 34}, reasons)
            self.assertEqual(instructions.read(path), ({KEY: 12, CLANG: 34}, reasons))


if __name__ == "__main__":
    unittest.main()
