#include "engine/effects/wobble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::wobble_test {
namespace {

using namespace effects_test;

SceneDef small() {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 96;
  def.clay.height = 0.1;
  def.wobble.emplace();
  return def;
}

double off(const Clay& clay, double height) {
  const OffCentre at = off_centre_of(clay, clay.first_row_above(height));
  return std::sqrt(at.x * at.x + at.z * at.z);
}

Hands beside(double distance, double height = 0.05) {
  Hands hands;
  hands.wheel_speed = 25.0;
  hands.hand[0] = {{distance, height, 0}, true, SideWish::outside};
  return hands;
}

TEST(Wobble, AFreshLumpLiesOffTheMiddleAndHoldsItsClay) {
  Scene scene = made(small());
  EXPECT_NEAR(off(scene.clay(), 0.05), 0.004, 1e-5);
  SceneDef centred = small();
  centred.wobble.reset();
  EXPECT_NEAR(scene.clay().volume() / made(centred).clay().volume(), 1.0, 1e-6);
  expect_whole(scene.clay());
}

TEST(Wobble, IsFeltAsABeatOnceATurn) {
  Scene scene = made(small());
  // Where only the high side reaches.
  const Hands hands = beside(0.055 + 0.008 + 0.003);
  int beats = 0;
  int last = -1000;
  for (int n = 0; n < 1000; ++n) {
    if (!scene.step(hands, 0.001).hand[0].contact) continue;
    beats += n > last + 50;
    last = n;
  }
  EXPECT_GE(beats, 1);
  EXPECT_LE(beats, 5);  // four turns, until what reaches is pressed away
}

TEST(Wobble, SteadyPressingCentresTheLump) {
  Scene scene = made(small());
  const double clay = scene.clay().volume();
  double last = off(scene.clay(), 0.05);
  for (int n = 0; n < 8000; ++n) {
    const double in = 0.004 - 0.005 * std::min(n / 6000.0, 1.0);
    scene.step(beside(0.063 + in), 0.001);
    if (n % 240 != 0) continue;
    const double now = off(scene.clay(), 0.05);
    EXPECT_LT(now, last + 2e-5) << n;
    last = now;
  }
  EXPECT_LT(last, 4e-4);
  // Most of it by moving, not by cutting: the lump as a whole is centred, where nobody pressed too.
  EXPECT_LT(off(scene.clay(), 0.066), 0.0035);
  EXPECT_GT(scene.clay().volume(), 0.93 * clay);
}

TEST(Wobble, NeverGrowsWithoutAHand) {
  Scene scene = made(small());
  Hands hands;
  hands.wheel_speed = 31.0;
  const std::uint64_t clay = scene.clay().hash();
  for (int n = 0; n < 5000; ++n) scene.step(hands, 0.001);
  EXPECT_EQ(scene.clay().hash(), clay);
}

TEST(Wobble, APushTowardsTheMiddleNeverTakesARingFartherOff) {
  SceneDef def = small();
  Result<Clay> clay = Clay::create(def.clay);
  for (int j = 0; j < clay->rows(); ++j) lay_off_centre(*clay, j, {0.004, 0.0});
  Wobble wobble;
  Random random(5);
  double last = 0.004;
  for (std::size_t n = 0; n < 3000; ++n) {
    const double angle = random.uniform(0.0, 6.28);
    const CentringHand hand{{0.07 * portable::cos(angle), 0.05, 0.07 * portable::sin(angle)},
                            random.uniform(0.0, 3.0),
                            random.uniform() < 0.5 ? WallSide::inside : WallSide::outside};
    const double seconds = random.uniform(1e-6, 0.005);
    wobble.press(n % 2, hand, seconds);
    wobble.centre(*def.wobble, *clay, seconds);
    ASSERT_LE(off(*clay, 0.05), last + 1e-8) << n;
    last = off(*clay, 0.05);
  }
  EXPECT_LT(last, 1e-4);
  EXPECT_NEAR(off(*clay, 0.095), 0.004, 1e-5);  // out of reach
}

TEST(Wobble, AHandThatGoesUpQuicklyLeavesNoRowFartherOffThanItsNeighbours) {
  SceneDef def = small();
  def.clay.rows = 400;
  def.clay.height = 0.2;
  def.clay.sectors = 512;  // four rows a tick
  Scene scene = made(def);
  for (int n = 0; n < 3000; ++n) scene.step(beside(0.0625, 0.03 + 0.04e-3 * n), 0.001);
  const Clay& clay = scene.clay();
  double rough = 0.0;
  for (int j = clay.first_row_above(0.05); j < clay.first_row_above(0.13); ++j) {
    const OffCentre a = off_centre_of(clay, j - 1);
    const OffCentre b = off_centre_of(clay, j);
    const OffCentre c = off_centre_of(clay, j + 1);
    rough = std::max({rough, std::fabs(a.x - 2 * b.x + c.x), std::fabs(a.z - 2 * b.z + c.z)});
  }
  EXPECT_LT(rough, 2e-5);
  EXPECT_LT(off(clay, 0.09), 0.003);
}

TEST(Wobble, SomeRowsUnderAHandMoveInEveryTickAndNeverManyAtOnce) {
  SceneDef def = small();
  def.clay.rows = 400;
  def.clay.height = 0.2;
  Result<Clay> clay = Clay::create(def.clay);
  for (int j = 0; j < clay->rows(); ++j) lay_off_centre(*clay, j, {0.004, 0.0});
  Wobble wobble;
  for (int n = 0; n < 140; ++n) {
    wobble.press(0, {{0.06, 0.1, 0.0}, 0.2, WallSide::outside}, 0.001);
    wobble.centre(*def.wobble, *clay, 0.001);
    int near = 0;
    for (int j = clay->take_dirty(); j >= 0; j = clay->take_dirty())
      near += std::fabs(clay->row_height(j) - 0.1) < 0.01 ? 1 : 0;
    // Forty of the rows that take turns within 20 ms are within a centimetre of the hand.
    if (n < 40) continue;
    EXPECT_GE(near, 1) << n;
    EXPECT_LE(near, 4) << n;
  }
}

TEST(Wobble, AFreshLumpIsOffTheMiddleAgainAndTheOldOneComesBackAsItWas) {
  Scene scene = made(small());
  for (int n = 0; n < 6000; ++n) scene.step(beside(0.067 - 8e-7 * n), 0.001);
  Hands hands;
  hands.wheel_speed = 25.0;
  for (int n = 0; n < 600; ++n) scene.step(hands, 0.001);
  const double centred = off(scene.clay(), 0.05);
  EXPECT_LT(centred, 0.002);
  hands.renew = true;
  for (int n = 0; n < 60; ++n, hands.renew = false) scene.step(hands, 0.001);
  EXPECT_NEAR(off(scene.clay(), 0.05), 0.004, 1e-5);
  hands.restore = true;
  for (int n = 0; n < 60; ++n, hands.restore = false) scene.step(hands, 0.001);
  EXPECT_EQ(off(scene.clay(), 0.05), centred);
}

TEST(Wobble, ARowThatDividesAndIsJoinedAgainLeavesTheTurnsWhereTheyWere) {
  const SceneDef def = small();
  Clay clay = std::move(*Clay::create(def.clay));
  for (int j = clay.floor_rows(); j < clay.rows(); ++j) lay_off_centre(clay, j, {0.004, 0.0});
  Wobble wobble;
  // Half a round: some strips' turns have begun, and none is at its end.
  for (int n = 0; n < 31; ++n) {
    wobble.press(0, {{0.055, 0.05, 0.0}, 0.5, WallSide::outside}, 0.001);
    wobble.centre(*def.wobble, clay, 0.001);
  }
  const auto hash = [&] {
    StateHash of;
    wobble.add_to(of, clay);
    return of.value();
  };
  const std::uint64_t before = hash();
  int moved = 0;
  for (int j = 0; j < clay.rows(); ++j) {
    wobble.row_divided(clay, {j});
    moved += hash() != before;
    wobble.rows_joined(clay, {j});
    ASSERT_EQ(hash(), before) << j;
  }
  EXPECT_GT(moved, clay.rows() / 4);
}

}  // namespace
}  // namespace onggi::effects::wobble_test
