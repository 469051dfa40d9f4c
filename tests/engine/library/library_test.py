#!/usr/bin/env python3
"""Installs the engine, moves it, and builds and runs engine/docs/example against it alone.

  library_test.py --build DIR --compiler CXX [--sanitize address,...] [--config Release]
"""

import argparse
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
EXAMPLE = os.path.join(ROOT, "engine", "docs", "example")
parser = argparse.ArgumentParser()
parser.add_argument("--build", required=True)
parser.add_argument("--compiler", required=True)
parser.add_argument("--sanitize", default="")
parser.add_argument("--config", default="Release")
ARGUMENTS, REST = parser.parse_known_args()


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise AssertionError(f"{' '.join(command)}\nexits {done.returncode}:\n{done.stdout}")
    return done.stdout


def under(folder, pattern):
    return {os.path.relpath(name, folder)
            for name in glob.glob(os.path.join(folder, pattern), recursive=True)}


class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="onggi-library")
        first = os.path.join(cls.folder.name, "installed")
        cls.prefix = os.path.join(cls.folder.name, "elsewhere")
        cls.work = os.path.join(cls.folder.name, "build")
        run("cmake", "--install", ARGUMENTS.build, "--config", ARGUMENTS.config, "--prefix", first)
        os.rename(first, cls.prefix)
        # A sanitized library wants its sanitizer at the last link.
        sanitize = f"-fsanitize={ARGUMENTS.sanitize}" if ARGUMENTS.sanitize else ""
        run("cmake", "-S", EXAMPLE, "-B", cls.work, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_PREFIX_PATH={cls.prefix}", f"-DCMAKE_CXX_COMPILER={ARGUMENTS.compiler}",
            f"-DCMAKE_CXX_FLAGS=-Wall -Wextra {sanitize}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
            "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF")
        run("cmake", "--build", cls.work)
        cls.printed = run(os.path.join(cls.work, "throw_a_cylinder"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def figure(self, name):
        found = re.search(rf"^{name} (\d+\.\d+) ", self.printed, re.M)
        self.assertIsNotNone(found, f"no {name} in:\n{self.printed}")
        return float(found.group(1))

    def test_the_pot_is_the_cylinder_that_was_asked_for(self):
        self.assertAlmostEqual(self.figure("height"), 150.0, delta=0.1)
        for name in ("foot", "belly", "mouth"):
            self.assertAlmostEqual(self.figure(name), 80.0, delta=2.0, msg=name)
        self.assertLess(self.figure("outline off by"), 1.0)
        self.assertGreaterEqual(self.figure("wall"), 4.0)  # wall_min
        self.assertLess(self.figure("wall"), 8.0)

    def test_the_hand_felt_it_and_the_guard_held(self):
        self.assertGreater(self.figure("most force"), 0.1)
        self.assertLessEqual(self.figure("most force"), 3.3)

    def test_every_header_of_the_engine_is_there_under_its_own_name(self):
        wanted = {name for name in under(ROOT, "engine/**/*.h") if not name.startswith("engine/docs/")}
        self.assertEqual(under(os.path.join(self.prefix, "include", "onggi"), "**/*.h"), wanted)

    def test_a_user_compiles_without_fused_multiply_add_as_the_library_was(self):
        with open(os.path.join(self.work, "compile_commands.json"), encoding="utf-8") as file:
            command = json.load(file)[0]["command"]
        self.assertIn("-ffp-contract=off", command)

    def test_nothing_installed_names_the_folder_it_was_built_in(self):
        packages = glob.glob(os.path.join(self.prefix, "**", "*.cmake"), recursive=True)
        self.assertTrue(packages)
        for name in packages:
            with open(name, encoding="utf-8") as file:
                text = file.read()
            for folder in (ROOT, os.path.realpath(ARGUMENTS.build)):
                self.assertNotIn(folder, text, name)

    def test_another_minor_version_is_not_taken_for_this_one(self):
        project = os.path.join(self.folder.name, "newer")
        os.makedirs(project)
        with open(os.path.join(project, "CMakeLists.txt"), "w", encoding="utf-8") as file:
            file.write("cmake_minimum_required(VERSION 3.25)\nproject(newer LANGUAGES NONE)\n"
                       "find_package(onggi 99.0 REQUIRED)\n")
        with self.assertRaisesRegex(AssertionError, "requested version"):
            run("cmake", "-S", project, "-B", project + "/build", "-G", "Ninja",
                f"-DCMAKE_PREFIX_PATH={self.prefix}")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *REST])
