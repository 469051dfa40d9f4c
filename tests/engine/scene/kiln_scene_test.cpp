#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/scene/scene.h"

namespace onggi::kiln_scene_test {
namespace {

std::uint64_t after_a_stroke(const SceneDef& def) {
  Scene scene = std::move(*Scene::create(def));
  Hands hands;
  hands.wheel_speed = 15.0;
  hands.hand[0].active = true;
  for (int n = 0; n < 1500; ++n) {
    hands.hand[0].position = {0.064 - 4e-6 * n, 0.05 + 5e-5 * n, 0.0};
    hands.water = n % 400 < 100;
    scene.step(hands, 0.001);
  }
  return scene.state_hash();
}

SceneDef small() {
  SceneDef def;
  def.clay.rows = 80;
  def.clay.sectors = 96;
  return def;
}

TEST(KilnScene, NothingOfTheKilnRunsOnTheTick) {
  SceneDef with = small();
  with.kiln.emplace();
  EXPECT_EQ(after_a_stroke(with), after_a_stroke(small()));
}

TEST(KilnScene, AnAbsentKilnFullOfNonsenseChangesNothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SceneDef without = small();
  without.kiln.emplace();
  without.kiln->drying_shrinkage = without.kiln->firing_shrinkage = kNan;
  without.kiln->glaze_thickness = kNan;
  EXPECT_FALSE(validate(without));
  without.kiln.reset();
  EXPECT_TRUE(validate(without));
  EXPECT_EQ(after_a_stroke(without), after_a_stroke(small()));
}

}  // namespace
}  // namespace onggi::kiln_scene_test
