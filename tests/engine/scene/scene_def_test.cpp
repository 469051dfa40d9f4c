#include "engine/scene/scene_def.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::scene_def_test {
namespace {

TEST(SceneDef, TheDefaultsAreGood) { EXPECT_TRUE(validate(SceneDef{})); }

TEST(SceneDef, EveryFieldIsCheckedAndNamed) {
  using Change = std::function<void(SceneDef&, double)>;
  const std::vector<std::pair<std::string, Change>> fields{
      {"clay.height", [](SceneDef& d, double v) { d.clay.height = v; }},
      {"tool.radius", [](SceneDef& d, double v) { d.tool.radius = v; }},
      {"contact.relaxation_time", [](SceneDef& d, double v) { d.contact.relaxation_time = v; }},
      {"contact.stiffness", [](SceneDef& d, double v) { d.contact.stiffness = v; }},
      {"wheel.max_speed", [](SceneDef& d, double v) { d.wheel.max_speed = v; }},
      {"wheel.acceleration", [](SceneDef& d, double v) { d.wheel.acceleration = v; }},
      {"guard.max_force", [](SceneDef& d, double v) { d.guard.max_force = v; }},
      {"guard.max_slew", [](SceneDef& d, double v) { d.guard.max_slew = v; }},
      {"guard.engage_time", [](SceneDef& d, double v) { d.guard.engage_time = v; }},
  };
  for (const auto& [name, change] : fields) {
    for (double bad : {-1.0, 1e12, std::numeric_limits<double>::quiet_NaN()}) {
      SceneDef def;
      change(def, bad);
      const Result<void> result = validate(def);
      ASSERT_FALSE(result) << name;
      EXPECT_EQ(result.error().where, name);
      EXPECT_FALSE(result.error().remedy.empty());
      EXPECT_FALSE(Scene::create(def));
    }
  }
}

TEST(SceneDef, ThePapersFieldsAreCheckedAndStandAlone) {
  SceneDef def;
  def.paper.emplace();
  EXPECT_EQ(validate(def).error().where, "paper.c_r");
  EXPECT_NE(validate(def).error().remedy.find("moisture"), std::string::npos);
  def.moisture.reset();
  EXPECT_NE(validate(def).error().remedy.find("friction"), std::string::npos);
  def.friction.reset();
  EXPECT_TRUE(validate(def));
  using Field = double PaperDef::*;
  for (const auto& [name, field] : {std::pair<const char*, Field>{"paper.c_eta", &PaperDef::c_eta},
                                    {"paper.c_v", &PaperDef::c_v},
                                    {"paper.c_r", &PaperDef::c_r}}) {
    for (double bad : {-1.0, 1e12, std::numeric_limits<double>::quiet_NaN()}) {
      SceneDef worse = def;
      (*worse.paper).*field = bad;
      ASSERT_FALSE(validate(worse)) << name;
      EXPECT_EQ(validate(worse).error().where, name);
    }
  }
}

TEST(SceneDef, AnImpossibleLumpIsRefusedWithFieldMeaningAndRemedy) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  using Change = std::function<void(ClayDef&)>;
  const std::vector<std::pair<std::string, Change>> lumps{
      {"clay.rows", [](ClayDef& c) { c.rows = 0; }},
      {"clay.rows", [](ClayDef& c) { c.rows = -400; }},
      {"clay.sectors", [](ClayDef& c) { c.sectors = 0; }},
      {"clay.rows", [](ClayDef& c) { c.rows = c.sectors = 1'000'000; }},  // 10^12 elements
      {"clay.rows", [](ClayDef& c) { c.rows = 20000, c.sectors = 8192; }},
      {"clay.rows", [](ClayDef& c) { c.rows = c.sectors = std::numeric_limits<int>::max(); }},
      {"clay.outer_radius", [](ClayDef& c) { c.inner_radius = c.outer_radius + 0.01; }},
      {"clay.outer_radius", [](ClayDef& c) { c.inner_radius = c.outer_radius; }},
      {"clay.outer_radius", [](ClayDef& c) { c.outer_radius = c.radius_max + 0.01; }},
      {"clay.outer_radius", [=](ClayDef& c) { c.outer_radius = kNan; }},
      {"clay.inner_radius", [=](ClayDef& c) { c.inner_radius = kNan; }},
      {"clay.inner_radius", [](ClayDef& c) { c.inner_radius = -0.01; }},
      {"clay.height", [=](ClayDef& c) { c.height = kInfinity; }},
      {"clay.floor_thickness", [=](ClayDef& c) { c.floor_thickness = kNan; }},
      {"clay.floor_thickness", [](ClayDef& c) { c.floor_thickness = 1.1 * c.height; }},
      {"clay.wall_min", [=](ClayDef& c) { c.wall_min = kNan; }},
      {"clay.radius_min", [=](ClayDef& c) { c.radius_min = kNan; }},
      {"clay.radius_max", [=](ClayDef& c) { c.radius_max = kNan; }},
  };
  for (const auto& [field, change] : lumps) {
    SceneDef def;
    change(def.clay);
    const Result<Scene> scene = Scene::create(def);
    ASSERT_FALSE(scene) << field;
    EXPECT_EQ(scene.error().where, field) << to_text(scene.error());
    EXPECT_GT(scene.error().what.size(), 10u) << field;
    EXPECT_GT(scene.error().remedy.size(), 10u) << field;
    EXPECT_EQ(scene.error().exit_code, 2);
  }
}

}  // namespace
}  // namespace onggi::scene_def_test
