#!/usr/bin/env python3
"""engine/docs/Doxyfile makes the manual of the headers, and a warning fails it.

  manual_test.py      exit 77: doxygen is not installed
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))


def doxygen(folder, *settings):
    with open(os.path.join(ROOT, "engine/docs/Doxyfile"), encoding="utf-8") as file:
        text = "\n".join([file.read(), f'OUTPUT_DIRECTORY = "{folder}"', *settings])
    return subprocess.run(["doxygen", "-"], input=text, cwd=ROOT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


class Manual(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="onggi-manual")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_the_headers_make_a_manual_without_a_warning(self):
        done = doxygen(self.folder)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("warning", done.stdout)
        with open(os.path.join(self.folder, "html", "classonggi_1_1Scene.html"),
                  encoding="utf-8") as file:
            self.assertIn("The numbered pipeline", file.read())

    def test_a_docstring_that_names_no_parameter_of_its_function_fails(self):
        header = os.path.join(self.folder, "wrong.h")
        with open(header, "w", encoding="utf-8") as file:
            file.write("/// Presses.\n/// @param depth metres\nvoid press(double force);\n")
        done = doxygen(self.folder, f'INPUT = "{header}"', "USE_MDFILE_AS_MAINPAGE =")
        self.assertNotEqual(done.returncode, 0, done.stdout)
        self.assertIn("depth", done.stdout)


if __name__ == "__main__":
    if not shutil.which("doxygen"):
        print("The manual: not checked, doxygen is not here. Install doxygen.")
        sys.exit(77)
    unittest.main()
