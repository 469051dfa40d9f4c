#include "engine/scene/lump.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/profile/measures.h"
#include "engine/scene/scene.h"
#include "engine/scene/wall_ring.h"
#include "tests/engine/script/vessels.h"

namespace onggi::lump_test {
namespace {

TEST(WorkspaceScale, BringsAVesselWithinReachAndKeepsItsShape) {
  Profile amphora = vessels::amphora();  // 62 cm
  const Profile p = scaled(amphora, workspace_scale(amphora));
  EXPECT_NEAR(p.height(), 0.20, 1e-9);
  Profile kylix = vessels::kylix();  // wider than high
  const Profile k = scaled(kylix, workspace_scale(kylix));
  EXPECT_NEAR(2.0 * k.max_radius(), 0.22, 1e-9);
}

TEST(Lump, IsAsTallAsTheTargetHasRoomForAFingerAndIsClearlyAnotherShape) {
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    SceneDef def;
    def.clay = lump_for(target, def);
    EXPECT_TRUE(validate(def)) << name;
    EXPECT_DOUBLE_EQ(def.clay.height, target.height());
    EXPECT_GT(def.clay.inner_radius, def.tool.radius) << name;
    EXPECT_GT(def.clay.outer_radius, def.clay.inner_radius + 1.5 * def.clay.wall_min) << name;
    const Scene scene = std::move(*Scene::create(def));
    const Measures m = compare(target, scene.clay().profile(), true);
    EXPECT_GT(m.outline_rms, 0.06) << name;
    EXPECT_LT(m.outline_overlap, 0.8) << name;
  }
}

// On a rounded foot the floor's widest place would stand out over the line as a step.
TEST(Lump, OfAPotThatIsBuiltIsAFloorAsWideAsTheVesselIsHalfwayUpIt) {
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    SceneDef def;
    def.volume.emplace();
    def.building.emplace();
    const double row = def.clay.height / def.clay.rows;
    def.clay = lump_for(target, def);
    ASSERT_TRUE(validate(def)) << name;
    const Profile floor = Scene::create(def)->clay().profile();
    EXPECT_NEAR(floor.height(), 0.010, 1e-6) << name;
    EXPECT_NEAR(floor.floor_height(), 0.010, 1e-6) << name << ": solid";
    EXPECT_NEAR(floor.max_radius(), target.outer_at(0.005), 1e-6) << name;
    EXPECT_NEAR(def.clay.height / def.clay.rows, row, 0.2 * row) << name << ": rows stay as fine";
  }
}

/// Where rings keep their clay and the pot does not, what a vessel's lump is.
SceneDef walled(const Profile& target) {
  SceneDef def;
  def.walls.emplace();
  def.clay = lump_for(target, def);
  return def;
}

TEST(Lump, WhereRingsKeepTheirClayItHasThatOfTheVesselsWallAndNoMore) {
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    const SceneDef def = walled(target);
    ASSERT_TRUE(validate(def)) << name;
    const scene::WallRing lump{def.clay.outer_radius, def.clay.inner_radius};
    EXPECT_GT(lump.outer - lump.inner, 1.25 * def.clay.wall_min) << name;
    EXPECT_GT(lump.inner, def.tool.radius) << name;
    const scene::WallRing belly = scene::worked(def, lump, target.max_radius());
    EXPECT_GT(belly.outer - belly.inner, def.clay.wall_min - 1e-9) << name;
    EXPECT_LT(belly.outer - belly.inner, 0.009) << name;
    EXPECT_GT(compare(target, Scene::create(def)->clay().profile(), true).outline_rms, 0.06)
        << name;
  }
}

// A lump as wide as the belly by half, with a bore of half of that, was solid in any such neck.
TEST(Lump, WhereRingsKeepTheirClayAMouthOfHalfTheBellyStaysOpen) {
  int asked = 0;
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    const double mouth = 0.5 * dimensions(target).mouth;
    if (mouth < std::max(0.45 * target.max_radius(), 0.03)) continue;
    ++asked;
    const SceneDef def = walled(target);
    const scene::WallRing rim =
        scene::worked(def, {def.clay.outer_radius, def.clay.inner_radius}, mouth);
    EXPECT_GT(rim.inner, 0.6 * rim.outer) << name;
  }
  EXPECT_GE(asked, 4);
}

}  // namespace
}  // namespace onggi::lump_test
