#!/usr/bin/env python3
"""The house checks themselves: a small good tree passes, and each kind of bad tree fails by name."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.realpath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import house  # noqa: E402
import page_truth  # noqa: E402


class House(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp(prefix="house")
        self.addCleanup(shutil.rmtree, self.root)
        with open(os.path.join(HERE, "rooms.txt"), encoding="utf-8") as file:
            self.write("tests/house/rooms.txt", file.read())
        self.write("tests/house/long_files.txt", "")
        self.write("tests/house/headers.txt", "")
        self.write("engine/docs/house.md", f"Before.\n{house.room_table.BEGIN}\n{house.room_table.END}\nAfter.\n")
        self.write("tests/house/public_names.txt", "")
        self.write("engine/base/result.h", "")
        self.write("engine/math/vec.h", "#include <cmath>\n")
        self.write("engine/clay/clay.h", '#include "engine/math/vec.h"\n')
        self.write("engine/clay/CMakeLists.txt", "onggi_room(engine/clay ROOMS engine/math)\n")
        self.write_table()

    def write(self, name, text):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def write_table(self):
        house.room_table.write_table(self.root, house.Table(os.path.join(self.root, "tests/house/rooms.txt")))

    def run_check(self, name):
        table = house.Table(os.path.join(self.root, "tests/house/rooms.txt"))
        return house.CHECKS[name](self.root, table)

    def check(self, name):
        return self.run_check(name)[0]

    def kept(self, name):
        """What the check says of a tree that passes."""
        return self.run_check(name)[1]

    def assert_broken(self, check, *words):
        broken = self.check(check)
        self.assertEqual(len(broken), 1, broken)
        for word in words:
            self.assertIn(word, broken[0])

    def test_a_good_tree_passes_every_check(self):
        for name in house.CHECKS:
            if name == "format" and not shutil.which("clang-format-14"):
                continue
            self.assertEqual(self.check(name), [], name)

    def test_lower_never_includes_higher(self):
        self.write("engine/math/vec.h", '#pragma once\n#include "engine/clay/clay.h"\n')
        self.assert_broken("includes", "engine/math/vec.h:2", "may not include engine/clay/clay.h")

    def test_a_new_public_name_is_listed_or_lies_in_its_rooms_namespace(self):
        self.write("engine/clay/clay.h", "namespace onggi {\nclass Bowl;\nnamespace clay {\n"
                   "struct Block { int n; };\n}\ntemplate <class T>\nstruct Key { T at; };\n}\n")
        self.assert_broken("names", "engine/clay/clay.h", "Key", "onggi::clay")
        self.write("tests/house/public_names.txt", "engine/clay : Key\n")
        self.assertEqual(self.check("names"), [])

    def test_functions_and_constants_are_public_names_too_and_a_name_that_is_gone_is_struck_out(self):
        self.write("engine/clay/clay.h", "namespace onggi {\ninline constexpr double kLip = f(3);\n"
                   "Result<void> bake(const Clay& c, int n = 2);\n"
                   "inline double area(double r) { return r; }\n}\n")
        self.write("tests/house/public_names.txt", "engine/clay : bake area kLip throw\n")
        self.assert_broken("names", "public_names.txt:1", "throw")

    def test_two_constants_of_one_name_fail_in_a_room_that_may_be_compiled_together(self):
        one, two = "namespace {\nconstexpr int kMost = 3, kLeast = 1;\n}\n", "constexpr double kLeast{2.0};\n"
        for room, fails in (("engine/clay", False), ("engine/profile", True)):
            self.write(f"{room}/a.cpp", one)
            self.write(f"{room}/b.cpp", "void f() {\n  " + two + "}\n")
            if fails:
                self.assert_broken("unity", f"{room}/b.cpp:2", "kLeast", f"{room}/a.cpp:2")
            else:
                self.assertEqual(self.check("unity"), [])
        self.write("engine/profile/b.cpp", "void f() {\n  if (kMost == 3) return;\n}\n")
        self.assertEqual(self.check("unity"), [])

    def test_a_file_of_tests_is_in_a_namespace_of_its_name(self):
        self.write("tests/engine/clay/row_test.cpp", "namespace onggi::clay {\nnamespace {\n")
        self.assert_broken("unity", "tests/engine/clay/row_test.cpp", "namespace onggi::row_test {")
        self.write("tests/engine/clay/row_test.cpp", "namespace onggi::clay::row_test {\nnamespace {\n")
        self.assertEqual(self.check("unity"), [])

    def test_effects_and_force_do_not_meet(self):
        self.write("engine/force/guard.cpp", '  #  include "engine/effects/slump.h"\n')
        self.assert_broken("includes", "engine/force/guard.cpp:1", "engine/effects")

    def test_the_engine_never_includes_the_kiosk(self):
        self.write("engine/scene/scene.cpp", '#include "kiosk/collection/settings/exhibit.h"\n')
        self.assert_broken("includes", "kiosk/collection/settings/exhibit.h")

    def test_the_rooms_of_a_wing_see_each_other_without_a_circle(self):
        self.write("kiosk/visit/access/access_mode.h", '#include "kiosk/visit/screens/visit.h"\n')
        self.assertEqual(self.check("includes"), [])
        self.write("kiosk/visit/screens/visit.h", '\n#include "kiosk/visit/sound/ear.h"\n')
        self.write("kiosk/visit/sound/ear.h", '#include "kiosk/visit/access/access_mode.h"\n')
        broken = self.check("includes")
        self.assertEqual(len(broken), 3, broken)
        self.assertIn("kiosk/visit/screens/visit.h:2: kiosk/visit/screens and kiosk/visit/sound go round in a circle",
                      "\n".join(broken))

    def test_a_wing_sees_only_what_its_line_says(self):
        self.write("kiosk/lab/commands/lab.cpp", '#include "kiosk/exhibit/composition/kiosk.h"\n')
        self.assertEqual(self.check("includes"), [])
        self.write("kiosk/lab/commands/lab.cpp", '#include "kiosk/program/commands/commands.h"\n')
        self.assert_broken("includes", "kiosk/lab/commands may not include kiosk/program/commands/commands.h")

    def test_a_subfolder_belongs_to_its_room(self):
        self.write("kiosk/picture/render/shaders/clay.h", '#include "kiosk/wheel/loop/status.h"\n')
        self.assert_broken("includes", "kiosk/picture/render may not include kiosk/wheel/loop/status.h")

    def test_docs_are_no_room_so_an_example_may_link_what_was_installed(self):
        self.write("engine/docs/example/CMakeLists.txt", "target_link_libraries(a onggi::engine)\n")
        self.write("engine/docs/example/a.cpp", '#include "engine/clay/clay.h"\n')
        for name in ("includes", "links", "layout"):
            self.assertEqual(self.check(name), [], name)

    def test_include_lines_start_at_the_root(self):
        self.write("engine/clay/clay.cpp", '#include "clay.h"\n')
        self.assert_broken("includes", 'Write "engine/clay/clay.h"')

    def test_our_own_headers_stand_in_quotes(self):
        self.write("engine/clay/clay.cpp", "#include <engine/clay/clay.h>\n")
        self.assert_broken("includes", "in quotes")

    def test_one_library_one_room(self):
        self.write("kiosk/visit/screens/visit.cpp", "#include <GLFW/glfw3.h>\n")
        self.assert_broken("includes", "It belongs to kiosk/picture/render")

    def test_an_unknown_library_is_refused(self):
        self.write("kiosk/visit/screens/visit.cpp", "#include <allegro5/allegro.h>\n")
        self.assert_broken("includes", "Give it one room")

    def test_the_engine_takes_no_clock_and_no_system_header(self):
        self.write("engine/clay/clay.cpp", "#include <chrono>\n")
        self.assert_broken("includes", "never includes <chrono>")
        self.write("engine/clay/clay.cpp", "#include <unistd.h>\n")
        self.assert_broken("includes", "unistd.h")

    def test_an_unlisted_room_is_named(self):
        self.write("kiosk/garage/old/car.cpp", "")
        self.assert_broken("includes", "kiosk/garage/old is not in tests/house/rooms.txt")
        self.assertTrue(self.check("layout"))

    def test_test_headers_stay_in_tests(self):
        self.write("engine/clay/clay.cpp", "#include <gtest/gtest.h>\n")
        self.assert_broken("includes", "gtest")
        os.remove(os.path.join(self.root, "engine/clay/clay.cpp"))
        self.write("tests/engine/clay/clay_test.cpp",
                   '#include <gtest/gtest.h>\n#include "tests/support/shapes.h"\n')
        self.assertEqual(self.check("includes"), [])

    def test_linking_obeys_the_table(self):
        self.write("engine/clay/CMakeLists.txt", "onggi_room(engine/clay\n  ROOMS engine/scene)\n")
        self.assert_broken("links", "engine/clay may not link engine/scene")

    def test_linking_a_library_of_another_room_fails(self):
        self.write("kiosk/collection/score/CMakeLists.txt", "onggi_room(kiosk/collection/score PUBLIC_LIBS glfw)\n")
        self.assert_broken("links", "may not link glfw", "kiosk/picture/render")

    def test_linking_around_the_table_fails(self):
        self.write("kiosk/collection/score/CMakeLists.txt",
                   "onggi_room(kiosk/collection/score)\ntarget_link_libraries(onggi_kiosk_collection_score PUBLIC glfw)\n")
        self.assert_broken("links", "link through onggi_room")

    def test_a_room_names_itself(self):
        self.write("kiosk/collection/score/CMakeLists.txt", "onggi_room(kiosk/picture/view)\n")
        self.assert_broken("links", "should name kiosk/collection/score")

    def test_global_flags_fail(self):
        self.write("CMakeLists.txt", "add_compile_options(-O3)\n")
        self.assert_broken("links", "CMakeLists.txt:1", "no global flags")

    def test_a_circle_in_the_table_is_found(self):
        self.write("tests/house/rooms.txt",
                   "engine/math : engine/clay\nengine/clay : engine/math\n")
        self.assertEqual(len(self.check("links")), 2)
        self.write("tests/house/rooms.txt", "kiosk/wheel : engine\nengine/clay : kiosk/wheel\nengine/math :\n")
        self.assertEqual(sum("reaches itself" in line for line in self.check("links")), 2)

    def test_a_file_of_401_lines_is_warned_of_and_one_of_601_fails(self):
        for lines, warned in ((400, False), (401, True), (600, True)):
            self.write("engine/clay/clay.cpp", "\n" * lines)
            self.assertEqual(self.check("length"), [])
            self.assertEqual(f"engine/clay/clay.cpp ({lines})" in self.kept("length"), warned, lines)
        self.write("engine/clay/clay.cpp", "\n" * 601)
        self.assert_broken("length", "engine/clay/clay.cpp: 601 lines")

    def test_a_long_table_passes_by_name_with_a_reason(self):
        self.write("engine/clay/table.cpp", "\n" * 700)
        self.write("tests/house/long_files.txt", "engine/clay/table.cpp : a table of constants\n")
        self.assertEqual(self.check("length"), [])
        self.write("tests/house/long_files.txt", "engine/clay/table.cpp\n")
        self.assert_broken("length", "say why")

    def test_a_stale_exception_fails(self):
        self.write("tests/house/long_files.txt", "engine/clay/gone.cpp : a table\n")
        self.assert_broken("length", "is gone")

    def test_a_source_without_a_header_of_its_own_fails_but_by_name_with_a_reason(self):
        self.write("engine/clay/slip.cpp", "")
        self.assert_broken("headers", "engine/clay/slip.cpp: it has no header of its own")
        self.write("tests/house/headers.txt", "engine/clay/*.cpp : clay.h declares them\n")
        self.assertEqual(self.check("headers"), [])
        self.write("tests/house/headers.txt", "engine/clay/slip.cpp\n")
        self.assert_broken("headers", "say why")

    def test_an_exception_that_nothing_needs_fails(self):
        self.write("engine/clay/slip.cpp", "")
        self.write("engine/clay/slip.h", "")
        self.write("tests/house/headers.txt", "engine/clay/slip.cpp : clay.h declares it\n")
        self.assert_broken("headers", "headers.txt:1", "needs no exception")

    def test_a_test_needs_no_header_of_its_own_nor_does_an_example(self):
        self.write("tests/engine/clay/clay_test.cpp", "")
        self.write("engine/docs/example/a.cpp", "")
        self.assertEqual(self.check("headers"), [])

    def test_two_headers_of_one_name_fail_wherever_they_are(self):
        self.write("tests/engine/math/clay.h", "")
        self.assert_broken("headers", "engine/clay/clay.h and tests/engine/math/clay.h share a name")
        self.write("tests/house/headers.txt", "clay.h : until one is renamed\n")
        self.assertEqual(self.check("headers"), [])

    def test_a_table_and_a_picture_that_are_not_those_of_the_law_fail_until_they_are_drawn_again(self):
        self.write("kiosk/collection/README.md", "")
        self.write("kiosk/collection/score/score.h", "")
        broken = self.check("docs")
        self.assertEqual(len(broken), 2, broken)
        for place in (house.room_table.DOCUMENT, house.room_table.PICTURE):
            self.assertTrue(any(place in line and "house.py table" in line for line in broken), place)
        self.write_table()
        self.assertEqual(self.check("docs"), [])
        with open(os.path.join(self.root, "engine/docs/house.md"), encoding="utf-8") as file:
            text = file.read()
        self.assertTrue(text.startswith("Before.\n") and text.endswith("After.\n"), text)
        self.assertRegex(text, r"(?m)^\| \[collection\].* \| what curators write.* \| score \| ground \| nlohmann, png,")
        with open(os.path.join(self.root, house.room_table.PICTURE), encoding="utf-8") as file:
            picture = file.read()
        self.assertIn(">collection</text>", picture)
        self.assertNotIn(">wheel</text>", picture)  # has no room yet

    def test_a_room_without_a_job_fails(self):
        self.write("tests/house/rooms.txt", "engine/math :  # numbers\nengine/clay : engine/math\n")
        self.write_table()
        self.assert_broken("docs", "say the job of engine/clay")

    def test_words_that_a_page_holds_to_a_source_are_held_on_both_sides(self):
        page = "# Clay\n```\n# no heading\n```\nA grid of 8 rows.\n"
        claim = "# Clay\n8 rows | engine/clay/clay.h | kRows = 8\n"
        claims = "engine/docs/claims/clay.txt"
        self.write("engine/clay/clay.h", "constexpr int kRows =\n    8;\n")
        self.write("engine/docs/clay.md", page)
        self.write(claims, claim)
        self.assertEqual(self.check("docs"), [])
        self.write("engine/clay/clay.h", "constexpr int kRows = 80;\n")
        self.assert_broken("docs", claims + ":2", "has no 'kRows = 8' any more")
        os.remove(os.path.join(self.root, "engine/clay/clay.h"))
        self.assert_broken("docs", "engine/clay/clay.h is gone")
        self.write("engine/clay/clay.h", "constexpr int kRows = 8;\n")
        self.write("engine/docs/clay.md", page.replace("of 8", "of nine"))
        self.assert_broken("docs", "does not say '8 rows'")
        self.write("engine/docs/clay.md", page.replace("A grid", "## Another section\nA grid"))
        self.assert_broken("docs", "does not say '8 rows'")
        self.write("engine/docs/clay.md", page)
        self.write(claims, claim.replace("# Clay", "# Mud"))
        self.assertTrue(any("has no heading 'Mud'" in line for line in self.check("docs")))
        self.write(claims, claim.replace(" | kRows = 8", ""))
        self.assert_broken("docs", "words | file | source text")
        self.write(claims, claim)
        os.remove(os.path.join(self.root, "engine/docs/clay.md"))
        self.assert_broken("docs", "engine/docs/clay.md is gone")

    def test_claims_of_a_page_outside_docs_stand_with_the_rules(self):
        self.write("config/README.md", "# Settings\n8 rows\n")
        self.write("tests/house/claims/config/README.txt", "# Settings\n9 rows | config/README.md | 8 rows\n")
        self.assert_broken("docs", "tests/house/claims/config/README.txt:2", "of config/README.md does not say '9 rows'")

    def test_a_claim_is_no_source_for_the_names_of_a_page(self):
        self.write("engine/docs/clay.md", "# Clay\n`Mud` of 8 rows.\n")
        self.write("engine/docs/claims/clay.txt", "# Clay\nMud | engine/docs/clay.md | Mud\n")
        self.assert_broken("docs", "nothing in the sources is called Mud")

    def test_a_comment_in_a_page_fails(self):
        self.write("engine/docs/clay.md", "# Clay\n\n<!-- to do -->\n")
        self.assert_broken("docs", "engine/docs/clay.md:3", "no reader sees a comment")

    def test_what_a_page_names_must_exist(self):
        self.write("engine/clay/clay.h", "struct Clay { int rows(); };\n")
        self.write("engine/docs/clay.md", "# The clay's [rows]\n[here](#the-clays-rows) [vec](../math/vec.h) `engine/clay` `clay.h` `clay/clay.h` `Clay::rows` "
                   "`rows()` `engine/*/vec.h` `build/bin/x` `engine/NAME.h` `--not checked`\n```\n`gone.h`\n```\n")
        self.assertEqual(self.check("docs"), [])
        for wrong, said in (("[vec](vec.h)", "vec.h leads nowhere"), ("[here](#rows)", "no heading for #rows"), ("`mud.h`", "no mud.h"),
                            ("`engine/mud`", "no engine/mud"), ("`Clay::sectors`", "called sectors")):
            self.write("engine/docs/clay.md", wrong + "\n")
            self.assert_broken("docs", said)

    def test_a_picture_is_drawn_by_the_command_and_shown_by_a_page(self):
        self.write(page_truth.PICTURES + "/pot.png", "")
        self.write(page_truth.DRAWN_BY, "# old.png\ntake pot.png here/*_pot.png\n")
        self.write("README.md", "![a pot](kiosk/docs/pictures/pot.png)\n")
        self.assertEqual(self.check("docs"), [])
        self.write("README.md", "")
        self.assert_broken("docs", "pot.png: no page shows it")
        self.write("README.md", "![a pot](kiosk/docs/pictures/pot.png)\n")
        self.write(page_truth.DRAWN_BY, "take jar.png here\n")
        self.assertEqual(len(self.check("docs")), 2)

    def test_the_top_level_is_fixed(self):
        self.write("utils/helper.cpp", "")
        self.assert_broken("layout", "utils: the top level is fixed")

    def test_a_loose_file_in_a_half_fails(self):
        self.write("engine/helper.cpp", "")
        self.assert_broken("layout", "engine/helper.cpp")

    def test_a_test_that_no_program_runs_fails(self):
        self.write("tests/clay_test.cpp", "")
        self.assert_broken("layout", "no program runs it")

    def test_a_test_that_writes_where_another_may_fails(self):
        self.write("tests/engine/clay/clay_test.cpp", "std::ofstream(testing::TempDir() + \"a.toml\");\n")
        self.assert_broken("layout", "ScratchFolder")

    @unittest.skipUnless(shutil.which("clang-format-14"), "clang-format-14 is not here")
    def test_a_badly_formatted_file_fails(self):
        self.write(".clang-format", "BasedOnStyle: Google\n")
        self.write("engine/clay/clay.cpp", "int   main( ) { }\n")
        self.assert_broken("format", "engine/clay/clay.cpp: not formatted")

    @unittest.skipUnless(shutil.which("cmake") and shutil.which("ninja"), "cmake is not here")
    def test_a_header_that_leans_on_another_include_does_not_compile_alone(self):
        project = os.path.join(HERE, "..", "..")
        for name in ("CMakeLists.txt", "engine/CMakeLists.txt", "engine/base/CMakeLists.txt"):
            with open(os.path.join(project, name), encoding="utf-8") as file:
                self.write(name, file.read())
        os.remove(os.path.join(self.root, "engine/clay/CMakeLists.txt"))
        build = os.path.join(self.root, "build")
        subprocess.run(["cmake", "-S", self.root, "-B", build, "-G", "Ninja", "-DONGGI_KIOSK=OFF",
                        "-DONGGI_TESTS=OFF"], capture_output=True, check=True)
        verify = ["cmake", "--build", build, "--target", "all_verify_interface_header_sets"]
        self.write("engine/base/list.h", "#include <vector>\ninline std::vector<int> list;\n")
        self.assertEqual(subprocess.run(verify, capture_output=True).returncode, 0)
        self.write("engine/base/list.h", "inline std::vector<int> list;\n")
        self.assertNotEqual(subprocess.run(verify, capture_output=True).returncode, 0)

    def test_the_command_exits_with_1_on_a_bad_tree_and_0_on_a_good_one(self):
        command = [sys.executable, "-B", os.path.join(HERE, "house.py"), "includes", "--root", self.root]
        self.assertEqual(subprocess.run(command, capture_output=True).returncode, 0)
        self.write("engine/math/vec.h", '#include "engine/clay/clay.h"\n')
        self.assertEqual(subprocess.run(command, capture_output=True).returncode, 1)


if __name__ == "__main__":
    unittest.main()
