// How hard paddle and anvil strike: what both have squeezes the wall, what one has more moves it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/effects/beating.h"
#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace onggi::effects::swing_test {
namespace {

constexpr double kOuter = 0.055, kWall = 0.010, kHeight = 0.06;

SceneDef wall() {
  SceneDef def;
  def.clay.rows = 120;
  def.clay.sectors = 180;
  def.clay.height = 0.120;
  def.clay.floor_thickness = 0.010;
  def.clay.outer_radius = kOuter;
  def.clay.inner_radius = kOuter - kWall;
  def.clay.wall_min = 0.001;
  def.volume.emplace();
  def.beating.emplace();
  return def;
}

struct Struck {
  double outer = 0.0, inner = 0.0;  // m that each face moved outwards, in the middle of the blow
  HandFeedback felt;
  std::uint32_t faults = 0;
};
/// One blow from outside, or from inside. `behind`: another hand holds the wall there.
Struck strike(SceneDef def, double swing, double anvil, bool from_inside = false,
              bool behind = false) {
  Scene scene = std::move(*Scene::create(def));
  Hands hands;
  HandInput& hand = hands.hand[0];
  hand.position = {from_inside ? kOuter - kWall - 0.012 : kOuter + 0.012, kHeight, 0.0};
  hand.active = hand.paddle = true;
  hand.swing = swing;
  hand.anvil = anvil;
  hands.hand[1].active = behind;
  hands.hand[1].position = {kOuter - kWall - def.tool.radius + 0.0002, kHeight, 0.0};
  for (int n = 0; n < 30; ++n) scene.step(hands, 0.001);
  const int j = scene.clay().first_row_above(kHeight);
  const auto radii = [&] {
    return Vec2{double{scene.clay().outer(j)[0]}, double{scene.clay().inner(j)[0]}};
  };
  const Vec2 before = radii();
  hand.blow = true;
  const Feedback felt = scene.step(hands, 0.001);
  const Vec2 after = radii();
  return {after.x - before.x, after.y - before.y, felt.hand[0], felt.faults};
}
double thinned(const Struck& struck) { return struck.inner - struck.outer; }

TEST(ASwing, OfOneOfThemAloneMovesTheWallByItsEnergy) {
  const SceneDef def = wall();
  const double load = portable::kPi * def.beating->yield_stress * kWall * kWall;
  for (const double share : {0.25, 0.6, 1.0}) {
    const double moves = share * def.beating->energy / load;
    const Struck paddle = strike(def, share, 0.0), anvil = strike(def, 0.0, share);
    EXPECT_NEAR(paddle.outer, -moves, 0.01 * moves) << share;
    EXPECT_NEAR(paddle.inner, -moves, 0.01 * moves);
    EXPECT_NEAR(anvil.outer, moves, 0.01 * moves) << "the anvil bulges it";
    EXPECT_NEAR(strike(def, share, 0.0, true).outer, moves, 0.01 * moves) << "as from inside";
    EXPECT_NEAR(thinned(paddle), 0.0, 1e-7);
  }
}

TEST(ASwing, OfBothSqueezesByTheLesserAndMovesByTheRest) {
  const SceneDef def = wall();
  const double load = portable::kPi * def.beating->yield_stress * kWall * kWall;
  const double squeezed = thinned(strike(def, 0.4, 0.4));
  EXPECT_GT(squeezed, 5e-5);
  for (const double rest : {0.1, 0.6}) {
    const Struck harder = strike(def, 0.4 + rest, 0.4), softer = strike(def, 0.4, 0.4 + rest);
    EXPECT_NEAR(thinned(harder), squeezed, 0.02 * squeezed) << rest;
    EXPECT_NEAR(thinned(softer), squeezed, 0.02 * squeezed);
    const double moves = rest * def.beating->energy / load;
    EXPECT_NEAR(0.5 * (softer.outer - harder.outer), moves, 0.02 * moves);
  }
  EXPECT_GT(thinned(strike(def, 1.0, 1.0)), 1.9 * squeezed) << "the whole energy";
}

// An anvil of next to nothing took the place of a hand that held the wall: a jump of 1.5 mm.
TEST(ASwing, OfTheWeakestAnvilTakesNoHandsPlace) {
  SceneDef def = wall();
  def.walls.emplace();
  const Struck hand = strike(def, 1.0, 0.0, false, true),
               both = strike(def, 1.0, 1e-6, false, true);
  EXPECT_GT(thinned(hand), 1e-4) << "it holds the wall";
  EXPECT_NEAR(both.outer, hand.outer, 1e-7);
  EXPECT_NEAR(both.inner, hand.inner, 1e-7);
}

TEST(ASwing, IsAsSteadyAsItIsAsked) {
  const SceneDef def = wall();
  Struck before = strike(def, 0.0, 1.0);
  for (int n = 1; n <= 40; ++n) {
    const double share = n / 40.0;
    const Struck now = strike(def, share, 1.0 - share);
    EXPECT_LT(std::fabs(now.outer - before.outer), 1.5e-4) << share;
    EXPECT_LT(std::fabs(now.inner - before.inner), 1.5e-4) << share;
    before = now;
  }
}

TEST(ASwing, OfNothingDoesNothingAndIsNoStepToTakeBack) {
  SceneDef def = wall();
  def.clay.keep_undo = true;
  const Struck none = strike(def, 0.0, 0.0);
  EXPECT_EQ(none.outer, 0.0);
  EXPECT_EQ(none.inner, 0.0);
  EXPECT_EQ(none.felt.blow, 0.0);
  Scene scene = std::move(*Scene::create(def));
  Hands hands;
  hands.hand[0].position = {kOuter + 0.012, kHeight, 0.0};
  hands.hand[0].active = hands.hand[0].paddle = true;
  hands.hand[0].swing = 0.0;
  for (int n = 0; n < 600; ++n) {
    hands.hand[0].blow = n % 200 < 100;
    scene.step(hands, 0.001);
  }
  EXPECT_FALSE(scene.can_restore());
}

TEST(ASwing, BeyondItsRangeIsAFaultAndNoBlow) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1e-9, 1.0 + 1e-7, 1e300})
    for (const bool swing : {true, false}) {
      const Struck struck = strike(wall(), swing ? bad : 1.0, swing ? 1.0 : bad);
      EXPECT_EQ(struck.outer, 0.0) << bad;
      EXPECT_TRUE((struck.faults & kFaultInput) != 0) << bad;
    }
}

}  // namespace
}  // namespace onggi::effects::swing_test
