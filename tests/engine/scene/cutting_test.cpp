#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

// Needle and loop take clay away wherever they meet it: what is missing of the pot's height times
// its ring is missing of its clay.
namespace onggi::cutting_test {
namespace {

Scene pot(const char* tool, double inner) {
  SceneDef def;
  def.clay.rows = 200;
  def.clay.sectors = 180;
  def.clay.inner_radius = inner;
  def.volume.emplace();
  def.tools = {{tool, {}}};
  return std::move(*Scene::create(def));
}

// Lowers tool 1 from just clear of `from`, m, by `way` in two seconds onto a turning pot.
void lower(Scene& scene, Vec3 from, double way) {
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.hand[0].active = true;
  hands.hand[0].tool = 1;
  for (int n = 0; n < 2500; ++n) {
    hands.hand[0].position = from - Vec3{0, way * std::min(n / 2000.0, 1.0), 0};
    scene.step(hands, 0.001);
  }
  hands.hand[0].active = false;
  for (int n = 0; n < 300; ++n) scene.step(hands, 0.001);
}

TEST(CutsAway, TheRimByAsMuchClayAsThePotGetsLower) {
  Scene scene = pot("loop_trimmer", 0.045);
  const double before = scene.clay().volume(), rim = scene.clay().rim_height();
  lower(scene, {0.05, rim + 0.009, 0}, 0.012);
  const double ring = portable::kPi * (0.055 * 0.055 - 0.045 * 0.045);
  const double sunk = rim - scene.clay().rim_height();
  const double gone = before - scene.clay().volume();
  EXPECT_GT(sunk, 0.001);
  EXPECT_NEAR(gone / (ring * sunk), 1.0, 0.05);
}

TEST(CutsAway, TheFloorByAsMuchClayAsTheHoleIsLarge) {
  Scene scene = pot("loop_trimmer", 0.03);
  const double before = scene.clay().volume(), rim = scene.clay().rim_height();
  const int solid = scene.clay().floor_rows();
  lower(scene, {0.0, 0.010 + 0.009, 0}, 0.013);
  const Clay& clay = scene.clay();
  ASSERT_LT(clay.floor_rows(), solid - 2);
  double hole = 0.0;
  for (int j = clay.floor_rows(); j < solid; ++j)
    hole += (portable::kPi * 0.055 * 0.055 - clay.measured_area(j)) * clay.row_thickness(j);
  EXPECT_NEAR((before - clay.volume()) / hole, 1.0, 0.02);
  EXPECT_NEAR(clay.rim_height(), rim, 1e-5) << "nothing of it is pushed up";
}

TEST(PushesAside, AFingerOnTheRimLosesNoClay) {
  Scene scene = pot("fingertip", 0.045);
  const double before = scene.clay().volume();
  lower(scene, {0.05, 0.2 + 0.009, 0}, 0.012);
  EXPECT_NEAR(scene.clay().volume() / before, 1.0, 1e-6);
}

}  // namespace
}  // namespace onggi::cutting_test
