#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/scene/frozen.h"

namespace onggi::felt_steps_test {
namespace {

constexpr double kRadius = 0.008;
// A ball of 8 mm that is pressed l deep into a flat face is pushed by k pi (2 R l - l^2) more for
// each metre: 1.2 mN a micrometre 3 mm deep, at 1e7 N/m^3.
constexpr double kLipschitz = 0.002;

SceneDef thin_wall(double thickness, double yield_stress = 9000.0) {
  SceneDef def = frozen(thickness);
  def.contact.stiffness = 1e7;
  def.walls.emplace().bending_strength = yield_stress;
  return def;
}

Hands one_hand(SideWish side) {
  Hands hands;
  hands.hand[0].active = true;
  hands.hand[0].side = side;
  return hands;
}

class ThinWall : public testing::TestWithParam<double> {};

TEST_P(ThinWall, IsFeltWithoutAStepWhereAHandInsideComesDownToTheFloor) {
  const SceneDef def = thin_wall(GetParam());
  const double inner = def.clay.inner_radius;
  const double at = inner - kRadius + 0.003;
  Scene scene = scene_of(def);
  EXPECT_LT(largest_step(scene, one_hand(SideWish::inside), {at, 0.0215, 0}, {at, 0.0165, 0}),
            kLipschitz);
}

TEST_P(ThinWall, IsFeltWithoutAStepWhereTheFootBegins) {
  const SceneDef def = thin_wall(GetParam());
  const double at = 0.055 + kRadius - 0.003;
  Scene scene = scene_of(def);
  EXPECT_LT(largest_step(scene, one_hand(SideWish::outside), {at, 0.022, 0}, {at, 0.006, 0}),
            kLipschitz);
}

// Hand 0 lies still, 3 mm deep; hand 1 comes to the other face, and goes 1 mm into it.
TEST_P(ThinWall, IsNotHeldByAHandThatGrazesItMoreThanThatHandPushes) {
  const SceneDef def = thin_wall(GetParam());
  Scene scene = scene_of(def);
  Hands hands = one_hand(SideWish::outside);
  hands.hand[0].position = {0.055 + kRadius - 0.003, 0.1, 0};
  hands.hand[1].active = true;
  hands.hand[1].side = SideWish::inside;
  double before = 0.0, other_before = 0.0;
  for (int n = 0; n < 1050; ++n) {
    hands.hand[1].position = {def.clay.inner_radius - kRadius - 5e-5 + 1e-6 * n, 0.1, 0};
    const Feedback felt = scene.step(hands, kFrozenTick);
    const double now = length(felt.hand[0].touch.push);
    const double other = length(felt.hand[1].touch.push);
    if (n > 0) {
      ASSERT_LT(std::fabs(now - before), 1.1 * std::fabs(other - other_before) + 1e-5) << n;
    }
    before = now;
    other_before = other;
  }
  EXPECT_GT(other_before, 0.01) << "the other hand came to the wall";
}

INSTANTIATE_TEST_SUITE_P(Of, ThinWall, testing::Values(0.004, 0.006, 0.010));

// With the wheel on and clay that gives way, as shipped: of a wall that bears any push the foot is
// felt as it comes; with a yield stress no more suddenly than twice that.
double largest_tick(double yield_stress) {
  SceneDef def = thin_wall(0.005, yield_stress);
  def.contact = {0.02, 1e7};
  def.guard.max_slew = 1e5;
  Scene scene = scene_of(def);
  Hands hands = one_hand(SideWish::inside);
  hands.wheel_speed = 10.0;
  const double inner = def.clay.inner_radius;
  double most = 0.0;
  Vec3 last;
  for (int n = 0; n < 2000; ++n) {
    const double deep = 0.004 * std::min(n / 1000.0, 1.0);
    const double down = n < 1000 ? 0.0 : 2e-5 * (n - 1000);
    hands.hand[0].position = {inner - kRadius + deep, 0.03 - down, 0};
    const Vec3 push = scene.step(hands, 0.001).hand[0].touch.push;
    if (n > 1000) most = std::max(most, length(push - last));
    last = push;
  }
  return most;
}

TEST(FeltSteps, IsNoMoreSuddenAtTheFloorThanOneThatBearsAnyPush) {
  EXPECT_LT(largest_tick(9000.0), 2.0 * largest_tick(0.0));
}

}  // namespace
}  // namespace onggi::felt_steps_test
