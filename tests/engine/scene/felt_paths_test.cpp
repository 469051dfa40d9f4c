#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/engine/scene/frozen.h"

// Clay that keeps its shape gives a hand back what the hand put in, whatever the path: also where a
// wall bends, more at one place than at another. tests/engine/contact/closed_paths_test.cpp has the
// paths of clay that does not bend.
namespace onggi::felt_paths_test {
namespace {

constexpr double kRadius = 0.008;

SceneDef bending(double thickness, double strength = 14722.0) {
  SceneDef def = frozen(thickness);
  def.contact.stiffness = 1e7;
  def.walls.emplace().bending_strength = strength;
  return def;
}

struct Work {
  double gained = 0.0, stored = 0.0;  // J: in all; the most that was put in before
};

// Hand 0 goes round `path`, straight from place to place.
Work round(Scene& scene, SideWish side, const std::vector<Vec3>& path) {
  scene.step({}, kFrozenTick);
  Hands hands;
  hands.hand[0] = {.position = path[0], .active = true, .side = side};
  Work work;
  pushed(scene, hands);
  for (std::size_t n = 0; n < path.size(); ++n) {
    const Vec3 from = path[n], way = path[(n + 1) % path.size()] - from;
    const int steps = static_cast<int>(std::ceil(length(way) / 2e-5));
    for (int k = 1; k <= steps; ++k) {
      hands.hand[0].position = from + (1.0 * k / steps) * way;
      const Vec3 force = pushed(scene, hands);
      work.gained += dot(force, (1.0 / steps) * way);  // that of the tick's middle
      work.stored = std::max(work.stored, -work.gained);
    }
  }
  return work;
}

// In where the wall is soft, out where it is firm, and the other way round. `path` begins clear of
// the clay. A round takes 3 ms at most, of the second in which this clay gives way.
void expect_nothing_gained(Scene scene, SideWish side, std::vector<Vec3> path) {
  const Work there = round(scene, side, path);
  std::reverse(path.begin() + 1, path.end());
  const Work back = round(scene, side, path);
  for (const Work& work : {there, back}) {
    EXPECT_GT(work.stored, 1e-4);
    EXPECT_LT(std::fabs(work.gained), 0.01 * work.stored) << "of " << work.stored << " J";
  }
}

class BendingWall : public testing::TestWithParam<double> {};

TEST_P(BendingWall, GivesNothingOnPathsAboutTheFoot) {
  for (const double deep : {0.002, 0.004, 0.007}) {
    const double clear = 0.055 + kRadius + 0.002, in = 0.055 + kRadius - deep;
    expect_nothing_gained(scene_of(bending(GetParam())), SideWish::outside,
                          {{clear, 0.028, 0}, {in, 0.028, 0}, {in, 0.0085, 0}, {clear, 0.0085, 0}});
    expect_nothing_gained(scene_of(bending(GetParam())), SideWish::outside,
                          {{clear, 0.02, 0}, {in, 0.0175, 0.003}, {in, 0.0085, -0.002}});
  }
}

TEST_P(BendingWall, GivesNothingOnPathsInsideTowardsTheFloor) {
  for (const double deep : {0.002, 0.004, 0.007}) {
    const double face = 0.055 - GetParam() - kRadius;
    expect_nothing_gained(scene_of(bending(GetParam())), SideWish::inside,
                          {{face - 0.002, 0.028, 0},
                           {face + deep, 0.028, 0},
                           {face + deep, 0.0185, 0},
                           {face - 0.002, 0.0185, 0}});
  }
}

INSTANTIATE_TEST_SUITE_P(Of, BendingWall, testing::Values(0.004, 0.010));

// A hand that stayed inside at one height, on a turning wheel, left the wall thinner there, and
// wet.
TEST(BendingWall, GivesNothingOnPathsWhereItIsThinnerAndWet) {
  SceneDef def = bending(0.008);
  def.walls->support = 0.2;
  def.moisture.emplace(MoistureDef{.wetting_time = 1.0, .sponge_height = 0.03});
  Scene scene = scene_of(def);
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.water = true;
  hands.hand[0] = {{0.055 + kRadius, 0.1, 0}, true, SideWish::outside};  // it holds the wall
  hands.hand[1] = {{0.047 - kRadius + 0.005, 0.1, 0}, true, SideWish::inside};
  for (int n = 0; n < 400; ++n) {
    hands.hand[0].position.x = 0.055 + kRadius - 1e-5 * std::min(n, 100);
    scene.step(hands, 0.005);
  }
  EXPECT_GT(scene.wetness_of(200), 0.5);
  EXPECT_EQ(scene.wetness_of(100), 0.0);
  for (int n = 0; n < 400; ++n) scene.step({}, 0.005);
  const double out = 0.055 + kRadius;
  expect_nothing_gained(std::move(scene), SideWish::outside,
                        {{out + 0.002, 0.07, 0},
                         {out - 0.005, 0.07, 0},
                         {out - 0.005, 0.1, 0.001},
                         {out + 0.002, 0.1, 0}});
}

}  // namespace
}  // namespace onggi::felt_paths_test
