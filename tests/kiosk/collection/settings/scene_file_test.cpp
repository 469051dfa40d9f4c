#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "engine/scene/scene.h"
#include "kiosk/collection/settings/scene_file.h"
#include "tests/kiosk/collection/settings/all_problems.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::settings::scene_file_test {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

SceneRead read(const std::string& text) {
  const files::test::ScratchFolder folder;
  std::ofstream(folder / "scene.toml", std::ios::binary) << text;
  return read_scene(folder / "scene.toml");
}

/// Every number of a definition in one line, with the effects that are there.
std::string figures(const SceneDef& d) {
  std::ostringstream out;
  out.precision(17);
  const ClayDef& c = d.clay;
  out << c.rows << ' ' << c.sectors << ' ' << c.height << ' ' << c.outer_radius << ' '
      << c.inner_radius << ' ' << c.floor_thickness << ' ' << c.floor_min << ' ' << c.wall_min
      << ' ' << c.radius_min << ' ' << c.radius_max << ' ' << c.keep_undo << ' ' << d.tool.radius
      << ' ' << d.contact.relaxation_time << ' ' << d.contact.stiffness << ' ' << d.wheel.max_speed
      << ' ' << d.wheel.acceleration << ' ' << d.guard.max_force << ' ' << d.guard.max_slew << ' '
      << d.guard.engage_time;
  each_effect(d, [&]<class Def>(const std::optional<Def>& effect) {
    if (!effect) return;
    out << ' ' << Def::kName;
    for (const DefField<Def>& field : Def::fields()) out << ' ' << (*effect).*(field.value);
  });
  if (d.paper) out << " paper " << d.paper->c_eta << ' ' << d.paper->c_v << ' ' << d.paper->c_r;
  return out.str();
}

TEST(scene, the_scenes_that_ship_are_without_fault_and_can_be_thrown_on) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator("config/scenes")) {
    ++scenes;
    const SceneRead r = read_scene(entry.path());
    EXPECT_THAT(r.problems, IsEmpty()) << entry.path() << "\n" << all(r.problems);
    EXPECT_GT(r.keys_checked, 0);
    auto scene = Scene::create(r.def);
    ASSERT_TRUE(scene);
    Hands hands;
    hands.wheel_speed = r.def.wheel.max_speed;
    hands.hand[0] = {{r.def.clay.outer_radius, r.def.clay.height / 2, 0}, true};
    double most = 0;
    for (int tick = 0; tick < 2000; ++tick)
      most = std::max(most, length(scene->step(hands, 0.001).hand[0].force));
    EXPECT_GT(most, 0.1) << "the clay is felt";
    EXPECT_LE(most, r.def.guard.max_force + 1e-9);
  }
  EXPECT_GE(scenes, 3);
}

TEST(scene, first_touch_is_the_engines_own_figures_written_out_with_walls_and_a_kiln) {
  const SceneRead r = read_scene("config/scenes/first_touch.toml");
  // Walls, and a kiln at the end, the engine has where they are asked for.
  SceneDef own;
  own.walls.emplace();
  own.kiln.emplace();
  own.moisture->drying_time = 90.0;  // a sponge's clay dries, too: with 60 s lines stay in a neck
  EXPECT_EQ(figures(r.def), figures(own));
  EXPECT_EQ(r.keys_checked, 30);
}

TEST(scene, every_effect_is_read_from_a_table_of_its_name_each_number_into_its_own_field) {
  SceneDef all_of_them;
  each_effect(all_of_them, []<class Def>(std::optional<Def>& effect) { effect.emplace(); });
  std::string text;
  double share = 0.25;
  each_effect(all_of_them, [&]<class Def>(std::optional<Def>& effect) {
    text += "[" + std::string(Def::kName) + "]\n";
    for (const DefField<Def>& field : Def::fields()) {
      double& number = (*effect).*(field.value);
      number = field.least + share * (field.most - field.least);
      if (std::string_view(field.key) == "tear_thickness") number = 0.0045;  // a kiosk takes less
      share = share < 0.7 ? share + 0.0625 : 0.25;
      std::ostringstream written;
      written.precision(17);
      written << number;
      text += std::string(field.key) + " = " + written.str() + "\n";
    }
  });
  const SceneRead r = read(text);
  EXPECT_THAT(r.problems, IsEmpty()) << all(r.problems);
  EXPECT_EQ(figures(r.def), figures(all_of_them));
}

TEST(scene, an_effect_is_there_where_its_table_is_written_and_absent_where_not) {
  const SceneRead none = read("");
  EXPECT_THAT(none.problems, IsEmpty());
  EXPECT_FALSE(none.def.friction);
  EXPECT_FALSE(none.def.moisture);
  const SceneRead wet = read("[moisture]\n");
  EXPECT_FALSE(wet.def.friction);
  ASSERT_TRUE(wet.def.moisture);
  EXPECT_EQ(wet.def.moisture->drying_time, MoistureDef{}.drying_time);
}

TEST(scene, a_kilns_clay_goes_by_name_and_a_number_beside_it_has_the_last_word) {
  const SceneRead r = read("[kiln]\nfiring_shrinkage = 0.1\nbody = \"porcelain\"\n");
  EXPECT_THAT(r.problems, IsEmpty()) << all(r.problems);
  ASSERT_TRUE(r.def.kiln);
  EXPECT_EQ(r.def.kiln->drying_shrinkage, find_clay_body("porcelain")->drying_shrinkage);
  EXPECT_EQ(r.def.kiln->firing_shrinkage, 0.1);
  EXPECT_FALSE(read("").def.kiln);
}

TEST(scene, a_clay_that_nobody_sells_is_told_with_the_nearest_and_stoneware_stands_in) {
  const SceneRead r = read("[kiln]\nbody = \"porcelin\"\nfiring_shrinkage = 0.5\n");
  ASSERT_THAT(r.problems, SizeIs(2)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":2:8"));
  EXPECT_THAT(r.problems[0].remedy, HasSubstr("Did you mean porcelain"));
  EXPECT_THAT(r.problems[1].what, HasSubstr("kiln.firing_shrinkage is 0.5"));
  EXPECT_EQ(r.def.kiln->firing_shrinkage, KilnDef{}.firing_shrinkage);
  EXPECT_THAT(read("[kiln]\nbody = \"marble\"\n").problems[0].remedy,
              HasSubstr("earthenware, stoneware, porcelain"));
}

TEST(scene, a_paddles_face_goes_by_name_and_another_word_is_told_with_the_nearest) {
  const std::string before = "[volume]\n[beating]\n[prints]\n";
  const SceneRead plain = read(before);
  EXPECT_THAT(plain.problems, IsEmpty()) << all(plain.problems);
  EXPECT_EQ(plain.def.prints->paddle, PrintsDef::plain);
  const SceneRead cord = read(before + "paddle = \"cord\"\npitch = 0.002\n");
  EXPECT_THAT(cord.problems, IsEmpty()) << all(cord.problems);
  EXPECT_EQ(cord.def.prints->paddle, PrintsDef::cord);
  EXPECT_EQ(cord.def.prints->pitch, 0.002);
  const SceneRead wrong = read(before + "paddle = \"gird\"\n");
  ASSERT_THAT(wrong.problems, SizeIs(1)) << all(wrong.problems);
  EXPECT_THAT(wrong.problems[0].where, EndsWith(":4:10"));
  EXPECT_THAT(wrong.problems[0].remedy, HasSubstr("Did you mean grid"));
  EXPECT_EQ(wrong.def.prints->paddle, PrintsDef::plain);
  EXPECT_THAT(read(before + "paddle = 2\n").problems, SizeIs(1)) << "a word, no number";
  EXPECT_FALSE(read("[volume]\n[beating]\n").def.prints);
  const SceneRead alone = read("[volume]\n[prints]\n");
  ASSERT_THAT(alone.problems, SizeIs(1)) << all(alone.problems);
  EXPECT_THAT(alone.problems[0].what, HasSubstr("prints needs beating"));
  EXPECT_FALSE(alone.def.prints);
}

TEST(scene, the_papers_scene_is_its_grid_its_model_and_nothing_else) {
  const SceneDef d = read_scene("config/scenes/paper.toml").def;
  ASSERT_TRUE(d.paper);
  EXPECT_TRUE(figures(d).ends_with(" 0.050000000000000003 paper 10 0.86399999999999999 200"))
      << figures(d);
  EXPECT_EQ(d.clay.rows, 400);
  EXPECT_EQ(d.clay.sectors, 360);
  EXPECT_DOUBLE_EQ(d.clay.height / d.clay.rows, 0.00018);
  EXPECT_FALSE(d.clay.keep_undo);
}

TEST(scene, an_effect_beside_the_papers_model_is_told_and_left_out) {
  const SceneRead r = read("[paper]\nc_eta = 12\n[friction]\ncoefficient = 0.1\n[moisture]\n");
  ASSERT_THAT(r.problems, SizeIs(2)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":3:1"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("friction cannot be combined with [paper]"));
  EXPECT_THAT(r.problems[1].where, EndsWith(":5:1"));
  EXPECT_FALSE(r.def.friction);
  EXPECT_FALSE(r.def.moisture);
  EXPECT_EQ(r.def.paper->c_eta, 12);
  EXPECT_TRUE(validate(r.def));
}

TEST(scene, the_tools_to_hand_are_those_that_it_names_and_all_where_it_names_none) {
  const auto names = [](const SceneDef& def) {
    std::string all;
    for (const SceneTool& tool : def.tools) all += tool.name + " ";
    return all;
  };
  const SceneRead few =
      read("[tool]\nto_hand = [\"wire\", \"needle\"]\n[needle]\nradius = 0.0004\n");
  EXPECT_THAT(few.problems, IsEmpty()) << all(few.problems);
  EXPECT_EQ(names(few.def), "needle wire ");
  EXPECT_EQ(few.def.tools[0].size.radius, 0.0004);
  EXPECT_EQ(names(read("[tool]\nto_hand = []\n").def), "");
  EXPECT_EQ(names(read("[tool]\nradius = 0.008\n").def), names(SceneDef{}));
}

TEST(scene, a_tool_that_nobody_makes_is_told_at_its_place_with_the_nearest) {
  const SceneRead scene = read("[tool]\nto_hand = [\"wire\", \"neddle\"]\n");
  ASSERT_THAT(scene.problems, SizeIs(1));
  EXPECT_THAT(all(scene.problems),
              HasSubstr("\"neddle\" is not a known tool.\n  Did you mean needle"));
  EXPECT_THAT(all(scene.problems), HasSubstr(":2"));
}

TEST(scene, quality_is_auto_or_fixed_and_never_of_the_printed_model) {
  EXPECT_TRUE(read("quality = \"auto\"\n[clay]\nrows = 200\n").auto_quality);
  EXPECT_EQ(read("quality = \"auto\"\n[clay]\nrows = 200\n").def.clay.rows, 200);
  EXPECT_FALSE(read("").auto_quality);
  EXPECT_FALSE(read("quality = \"fixed\"\n").auto_quality);
  EXPECT_FALSE(read("quality = \"auto\"\n[paper]\n").auto_quality);
  const SceneRead wrong = read("quality = \"best\"\n");
  ASSERT_THAT(wrong.problems, SizeIs(1));
  EXPECT_NE(wrong.problems[0].remedy.find("auto"), std::string::npos);
}

TEST(scene, every_number_is_read_into_its_own_field) {
  const SceneRead r = read(R"([clay]
rows = 100
sectors = 200
height = 0.3
outer_radius = 0.07
inner_radius = 0.03
floor_thickness = 0.02
floor_min = 0.003
wall_min = 0.005
radius_min = 0.004
radius_max = 0.2
keep_undo = false
[tool]
radius = 0.01
[contact]
relaxation_time = 0.02
stiffness = 1e6
[wheel]
max_speed = 20
acceleration = 10
[guard]
max_force = 2
max_slew = 100
engage_time = 1
)");
  EXPECT_THAT(r.problems, IsEmpty()) << all(r.problems);
  EXPECT_EQ(r.keys_checked, 19);
  EXPECT_EQ(figures(r.def),
            "100 200 0.29999999999999999 0.070000000000000007 0.029999999999999999 0.02 "
            "0.0030000000000000001 "
            "0.0050000000000000001 0.0040000000000000001 0.20000000000000001 0 0.01 0.02 1000000 "
            "20 10 2 100 1");
}

TEST(scene, what_the_engine_refuses_is_told_at_its_line_and_the_rest_is_kept) {
  const SceneRead r = read("[clay]\nrows = 4\nheight = 0.3\n[guard]\nmax_force = 50\n[contcat]\n");
  ASSERT_THAT(r.problems, SizeIs(3)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":2:8"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("clay.rows is 4"));
  EXPECT_THAT(r.problems[1].where, EndsWith(":5:13"));
  EXPECT_THAT(r.problems[1].remedy, HasSubstr("22.2 N"));
  EXPECT_THAT(r.problems[2].remedy, HasSubstr("Did you mean contact"));
  EXPECT_EQ(r.def.clay.rows, ClayDef{}.rows);
  EXPECT_EQ(r.def.clay.height, 0.3);
}

TEST(scene, a_key_of_before_is_read_and_told_with_its_new_name) {
  const SceneRead r = read("[walls]\nsupport = 0.02\nyield_stress = 7000\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":3:16"));
  EXPECT_EQ(r.problems[0].what, "yield_stress is the old name of bending_strength.");
  EXPECT_EQ(r.problems[0].remedy,
            "Write bending_strength in its place. Until then the kiosk reads it as that.");
  ASSERT_TRUE(r.def.walls);
  EXPECT_EQ(r.def.walls->bending_strength, 7000.0);
  EXPECT_EQ(r.def.walls->support, 0.02);
  const SceneRead both = read("[walls]\nyield_stress = 7000\nbending_strength = 8000\n");
  EXPECT_EQ(both.def.walls->bending_strength, 8000.0);
  const SceneRead wild = read("[walls]\nyield_stress = -1\nsupport = 0.02\n");
  EXPECT_THAT(wild.problems, SizeIs(2)) << all(wild.problems);
  EXPECT_EQ(wild.def.walls->bending_strength, WallsDef{}.bending_strength);
  EXPECT_EQ(wild.def.walls->support, 0.02);
}

// By Mises clay yields along one way at sqrt(3) times what it bears in shear.
TEST(scene, shipped_clay_is_as_strong_to_a_finger_as_to_its_weight) {
  int both = 0;
  for (const char* name : {"first_touch", "studio", "master"}) {
    const SceneDef def = read_scene(std::string("config/scenes/") + name + ".toml").def;
    if (!def.walls || !def.slump) continue;
    ++both;
    EXPECT_NEAR(def.walls->bending_strength / (std::sqrt(3.0) * def.slump->yield_stress), 1.0, 1e-3)
        << name;
  }
  EXPECT_EQ(both, 1);  // master
}

TEST(scene, a_grid_that_the_engine_takes_and_no_kiosk_draws_is_told_and_is_not_used) {
  EXPECT_THAT(read("[clay]\nrows = 2048\nsectors = 2048\n").problems, IsEmpty());
  EXPECT_THAT(read("[clay]\nsectors = 8192\n").problems, IsEmpty());
  for (const char* grid : {"[clay]\nrows = 2049\nsectors = 2048\n", "[clay]\nrows = 20000\n",
                           "[clay]\nrows = 4096\nsectors = 8192\n"}) {
    const SceneRead r = read(grid);
    ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
    EXPECT_THAT(r.problems[0].where, EndsWith(":2:8"));
    EXPECT_THAT(r.problems[0].what, HasSubstr("a kiosk draws at most 4194304"));
    EXPECT_EQ(r.def.clay.rows, ClayDef{}.rows);
  }
}

TEST(scene, clay_that_cannot_carry_its_own_lump_is_told_and_is_not_used) {
  // 1950 kg/m^3 * 9.81 m/s^2 * 0.2 m / sqrt(3) = 2208.9 Pa
  EXPECT_THAT(read("[volume]\n[slump]\nyield_stress = 2209\n").problems, IsEmpty());
  const SceneRead r = read("[volume]\n[slump]\nyield_stress = 2208\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":3:16"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("the lump of the tallest vessel, 200 mm"));
  EXPECT_THAT(r.problems[0].remedy, HasSubstr("at least 2209"));
  EXPECT_EQ(r.def.slump->yield_stress, SlumpDef{}.yield_stress);
  for (const char* height : {"0.1", "0.4"}) {
    const std::string clay = std::string("[clay]\nheight = ") + height + "\n[volume]\n[slump]\n";
    EXPECT_THAT(read(clay + "yield_stress = 2208\n").problems, SizeIs(1)) << height;
    EXPECT_THAT(read(clay + "yield_stress = 2209\n").problems, IsEmpty())
        << "a visit's lump is as tall as its vessel";
  }
}

TEST(scene, walls_that_tear_before_they_are_thrown_are_told_and_are_not_used) {
  EXPECT_THAT(read("[walls]\nsupport = 0.03\ntear_thickness = 0.005\n").problems, IsEmpty());
  const SceneRead r = read("[walls]\nsupport = 0.03\ntear_thickness = 0.0051\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":3:18"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("more than 5 mm"));
  EXPECT_EQ(r.def.walls->tear_thickness, 0.0);
  EXPECT_EQ(r.def.walls->support, 0.03);
}

TEST(scene, values_that_contradict_a_default_are_told_at_their_table) {
  const SceneRead r = read("[tool]\nradius = 0.01\n[clay]\ninner_radius = 0.09\nrows = 100\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":3:1"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("clay.outer_radius"));
  EXPECT_EQ(r.def.clay.inner_radius, ClayDef{}.inner_radius);
  EXPECT_EQ(r.def.tool.radius, 0.01);
}

TEST(scene, whatever_is_written_the_scene_can_be_thrown_on) {
  EXPECT_TRUE(rc::check([](const std::vector<std::pair<std::uint8_t, double>>& values) {
    static const char* const kKeys[] = {
        "clay.rows",          "clay.sectors",      "clay.height",
        "clay.outer_radius",  "clay.inner_radius", "clay.floor_thickness",
        "clay.floor_min",     "clay.wall_min",     "clay.radius_min",
        "clay.radius_max",    "tool.radius",       "contact.stiffness",
        "wheel.max_speed",    "guard.max_force",   "friction.coefficient",
        "moisture.softening", "moisture.tide",     "paper.c_eta",
        "paper.c_v",          "paper.c_r"};
    std::map<std::string, std::string> lines;
    for (const auto& [pick, value] : values) {
      std::ostringstream number;
      number.precision(17);
      number << (pick % 3 == 0 ? value : value / 1e3);
      lines[kKeys[pick % std::size(kKeys)]] = number.str();
    }
    std::string text;
    for (const auto& [key, value] : lines) text += key + " = " + value + "\n";
    const SceneRead r = read(text);
    RC_ASSERT(validate(r.def).has_value());
    for (const Problem& p : r.problems) {
      RC_ASSERT(p.where.find(".toml:") != std::string::npos);
      RC_ASSERT(!p.remedy.empty());
    }
  }));
}

TEST(scene, a_file_that_is_not_there_leaves_the_engines_own_scene) {
  const SceneRead r = read_scene("config/scenes/frist_touch.toml");
  ASSERT_THAT(r.problems, SizeIs(1));
  EXPECT_EQ(figures(r.def), figures(SceneDef{}));
}

}  // namespace
}  // namespace onggi::settings::scene_file_test
