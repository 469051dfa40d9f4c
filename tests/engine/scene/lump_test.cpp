#include "engine/scene/lump.h"

#include <gtest/gtest.h>

#include "engine/profile/measures.h"
#include "engine/scene/scene.h"
#include "tests/engine/script/vessels.h"

namespace onggi {
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

}  // namespace
}  // namespace onggi
