"""What a machine is told that lacks something: libraries, by CMake, and packages, by kiosk/install-packages."""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Libraries(unittest.TestCase):
    def configure(self, folder, *words):
        run = subprocess.run(["cmake", "-S", ROOT, "-B", os.path.join(folder, "build"), "-G", "Ninja", "-DONGGI_TESTS=OFF",
                              *words], capture_output=True, text=True, check=False)
        return run.returncode, " ".join(run.stderr.split())

    def test_what_is_missing_and_what_is_too_old_are_told_at_once_with_the_package(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "glfw3Config.cmake").write_text("set(glfw3_FOUND 1)\n")
            pathlib.Path(folder, "glfw3ConfigVersion.cmake").write_text(
                "set(PACKAGE_VERSION 3.2.1)\nset(PACKAGE_VERSION_COMPATIBLE 1)\n")
            code, told = self.configure(folder, "-DCMAKE_DISABLE_FIND_PACKAGE_TinyGLTF=ON", f"-Dglfw3_DIR={folder}")
        self.assertNotEqual(code, 0)
        self.assertIn("TinyGLTF is not here, 2.7 or newer is needed (Debian: libtinygltf-dev)", told)
        self.assertIn("glfw3 3.2.1 is here, 3.3 or newer is needed (Debian: libglfw3-dev)", told)
        self.assertIn("bash kiosk/install-packages kiosk/packages.txt", told)
        self.assertNotIn("spdlog", told)

    def test_the_engines_library_and_the_kiosks_are_told_together(self):
        with tempfile.TemporaryDirectory() as folder:
            code, told = self.configure(folder, "-DCMAKE_DISABLE_FIND_PACKAGE_tl-expected=ON",
                                        "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON")
        self.assertNotEqual(code, 0)
        self.assertIn("tl-expected is not here", told)
        self.assertIn("PNG is not here", told)

    def test_without_pkg_config_nothing_is_said_of_the_libraries_that_it_would_find(self):
        with tempfile.TemporaryDirectory() as folder:
            code, told = self.configure(folder, "-DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON")
        self.assertNotEqual(code, 0)
        self.assertEqual(told.count("pkg-config is not here (Debian: pkg-config)"), 1, told)
        self.assertNotIn("WEBP", told)

    def test_a_library_that_does_not_say_its_version_is_told_so(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "TinyGLTFConfig.cmake").write_text("set(TinyGLTF_FOUND 1)\n")
            code, told = self.configure(folder, f"-DTinyGLTF_DIR={folder}")
        self.assertNotEqual(code, 0)
        self.assertIn("TinyGLTF of an unknown version is here, 2.7 or newer is needed", told)

    def test_a_library_that_one_can_do_without_stops_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            code, told = self.configure(folder, "-DCMAKE_DISABLE_FIND_PACKAGE_assimp=ON")
        self.assertEqual(code, 0, told)

    def test_versions_are_asked_for_in_one_file(self):
        asking = [str(path.relative_to(ROOT)) for path in ROOT.glob("**/CMakeLists.txt")
                  if path.relative_to(ROOT).parts[0] in ("engine", "kiosk", "tests")
                  and "AT_LEAST" in path.read_text()]
        self.assertEqual(asking, [])
        self.assertIn("AT_LEAST", (ROOT / "kiosk/libraries.cmake").read_text())


class Packages(unittest.TestCase):
    def install(self, release):
        with tempfile.TemporaryDirectory() as folder:
            told = pathlib.Path(folder, "os-release")
            told.write_text(release)
            pathlib.Path(folder, "packages.txt").write_text("bash  # why\n# a comment\nonggi-no-such-package\n")
            return subprocess.run(["bash", ROOT / "kiosk/install-packages", os.path.join(folder, "packages.txt")],
                                  env={**os.environ, "ONGGI_OS_RELEASE": str(told)},
                                  capture_output=True, text=True, check=False)

    def test_another_system_gets_one_sentence_with_the_list(self):
        for release in ('ID=fedora\nVERSION_ID=43\nPRETTY_NAME="Fedora Linux 43"\n', "ID=debian\nVERSION_ID=11\n", ""):
            run = self.install(release)
            self.assertEqual(run.returncode, 2, release)
            self.assertEqual(run.stdout, "")
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
            self.assertIn("Debian 12 and 13 only", run.stderr)
            self.assertTrue(run.stderr.endswith("`build/release/bin/onggi run`: bash onggi-no-such-package\n"), run.stderr)
        self.assertIn("Fedora Linux 43", self.install('ID=fedora\nPRETTY_NAME="Fedora Linux 43"\n').stderr)


    def test_without_a_list_it_says_how_it_is_used_and_waits_for_nobody(self):
        run = subprocess.run(["bash", ROOT / "kiosk/install-packages"], stdin=subprocess.DEVNULL, capture_output=True,
                             text=True, check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("usage: kiosk/install-packages LIST", run.stderr)


if __name__ == "__main__":
    unittest.main()
