#include "kiosk/wheel/device/wall_hold.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::device::wall_hold_test {
namespace {

constexpr WallHold::Part kPalm{2, 0.018}, kFinger{0, 0.008};

/// A wall 6 mm thick whose outside runs from `foot` to `mouth`, 0.2 m high, on a floor of 10 mm.
ClayView wall(double foot, double mouth) {
  ClayDef def;
  def.rows = 200;
  def.sectors = 16;
  def.height = 0.2;
  def.floor_thickness = 0.01;
  ClayView clay;
  clay.lay(def);
  std::vector<float> outer(16), inner(16);
  for (int j = 0; j < def.rows; ++j) {
    const double r = foot + (mouth - foot) * clay.row_height(j) / 0.2;
    std::ranges::fill(outer, static_cast<float>(r));
    std::ranges::fill(inner, static_cast<float>(r - 0.006));
    clay.shape(j, outer, inner);
  }
  return clay;
}

/// How far a ball's surface is from the straight outside of wall(), m: below 0 it is in the clay.
double clear_of(const WallHold::Stand& ball, double foot, double mouth, double thickness) {
  const double slant = (mouth - foot) / 0.2;
  const double face = foot - thickness + slant * ball.height;
  const double off = (ball.radius - face) / std::hypot(1.0, slant);
  return (thickness == 0 ? off : -off) - ball.part.radius;
}

TEST(WallHold, BothHandsTouchAWallSquareOnWhateverItsSlant) {
  for (const auto& [foot, mouth] : {std::pair{0.08, 0.08}, {0.05, 0.12}, {0.12, 0.06}}) {
    const ClayView clay = wall(foot, mouth);
    WallHold hold(kPalm, kFinger);
    hold.take(clay, Grip::both, 0.1);
    const double face = hold.face(clay, 0.1);
    const auto hands = hold.stand(clay, face, 0.1);
    ASSERT_TRUE(hands.outside.there);
    ASSERT_TRUE(hands.inside.there);
    EXPECT_NEAR(clear_of(hands.outside, foot, mouth, 0), 0, 2e-4) << foot << ' ' << mouth;
    EXPECT_NEAR(clear_of(hands.inside, foot, mouth, 0.006), 0, 2e-4) << foot << ' ' << mouth;
  }
}

TEST(WallHold, WhereAWallIsBeingThinnedTheHandInsideGoesAlongSmoothly) {
  // Thin below 0.1 m, where hands have been, and thick above.
  ClayView clay = wall(0.08, 0.08);
  std::vector<float> outer(16, 0.08f), inner(16, 0.05f);
  for (int j = 0; j < clay.rows(); ++j)
    if (clay.row_height(j) > 0.1) clay.shape(j, outer, inner);
  WallHold hold(kPalm, kFinger);
  hold.take(clay, Grip::both, 0.05);
  double last = 0, widest = 0;
  for (double h = 0.05; h < 0.15; h += 0.001) {
    const double inside = hold.stand(clay, 0.08, h).inside.radius;
    if (last > 0) widest = std::max(widest, std::abs(inside - last));
    last = inside;
  }
  EXPECT_LT(widest, 0.004);  // of the 24 mm that the wall gets thicker by at once
}

TEST(WallHold, InABowlTheInnerHandLiesAboveTheOuterOneAndOnAShoulderBelow) {
  WallHold hold(kPalm, kFinger);
  const ClayView bowl = wall(0.05, 0.12), shoulder = wall(0.12, 0.05);
  hold.take(bowl, Grip::both, 0.1);
  const auto in_bowl = hold.stand(bowl, hold.face(bowl, 0.1), 0.1);
  EXPECT_GT(in_bowl.inside.height, in_bowl.outside.height + 0.005);
  hold.take(shoulder, Grip::both, 0.1);
  const auto on_shoulder = hold.stand(shoulder, hold.face(shoulder, 0.1), 0.1);
  EXPECT_LT(on_shoulder.inside.height, on_shoulder.outside.height - 0.005);
}

TEST(WallHold, WhatGoesInIsAsBroadAsTheMouthLets) {
  WallHold hold(kPalm, kFinger);
  const ClayView wide = wall(0.08, 0.08), narrow = wall(0.08, 0.018);
  hold.take(wide, Grip::both, 0.1);
  EXPECT_EQ(hold.stand(wide, 0.08, 0.1).inside.part.tool, kPalm.tool);
  hold.take(narrow, Grip::both, 0.1);
  EXPECT_EQ(hold.stand(narrow, 0.05, 0.1).inside.part.tool, kFinger.tool);
}

TEST(WallHold, WhereTheFootIsSolidTheOuterHandWorksAlone) {
  WallHold hold(kPalm, kFinger);
  const ClayView pot = wall(0.08, 0.08);
  hold.take(pot, Grip::both, 0.005);
  EXPECT_TRUE(hold.solid(pot, 0.005));
  EXPECT_FALSE(hold.stand(pot, 0.08, 0.005).inside.there);
  // No finger is in the foot: it may be as slender as one likes.
  EXPECT_NEAR(hold.stand(pot, 0.005, 0.005).outside.radius, 0.005 + kPalm.radius, 1e-9);
}

/// A lump as it comes to the wheel: a wall of `outer` - `inner`, m.
ClayView lump_of(double outer, double inner) {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  def.outer_radius = outer;
  def.inner_radius = inner;
  ClayView clay;
  clay.lay(def);
  return clay;
}

// Rings keep their clay: were both hands to go inwards, a thick wall would close its bore.
TEST(WallHold, CollaringThinsAThickWallAndTakesAThinOneAlong) {
  WallHold hold(kPalm, kFinger);
  const ClayView thick = lump_of(0.06, 0.03), thin = lump_of(0.06, 0.054);
  hold.take(thick, Grip::both, 0.1);
  const double before = hold.stand(thick, 0.06, 0.1).inside.radius;
  EXPECT_NEAR(hold.stand(thick, 0.05, 0.1).inside.radius, before, 1e-6) << "it stays";
  EXPECT_NEAR(hold.stand(thick, 0.035, 0.1).inside.radius, 0.035 - WallHold::kThick - 0.018, 1e-6);
  hold.take(thin, Grip::both, 0.1);
  EXPECT_NEAR(hold.stand(thin, 0.05, 0.1).inside.radius,
              hold.stand(thin, 0.06, 0.1).inside.radius - 0.01, 1e-6);
  EXPECT_NEAR(hold.stand(thick, 0.07, 0.1).inside.radius, 0.07 - 0.03 - 0.018, 1e-6)
      << "opened, a thick wall is pushed as it is";
}

TEST(WallHold, AFingerOpensABoreThatIsNarrowerThanItself) {
  WallHold hold(kPalm, kFinger);
  const ClayView closed = lump_of(0.04, 0.003);
  hold.take(closed, Grip::both, 0.1);
  const auto hands = hold.stand(closed, 0.04, 0.1);
  ASSERT_TRUE(hands.inside.there);
  EXPECT_GT(hands.inside.radius + kFinger.radius, 0.003);
}

RC_GTEST_PROP(WallHold, HandsThatHoldAWallNeverCloseItOverTheFingerInside, ()) {
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  const ClayView clay = wall(metres(20, 120), metres(20, 120));
  WallHold hold(kPalm, kFinger);
  hold.take(clay, Grip::both, 0.1);
  const double height = metres(12, 198);
  const auto hands = hold.stand(clay, metres(0, 150), height);
  // A finger, the 3 mm of wall that two hands can hold, and a millimetre to spare.
  RC_ASSERT(hands.outside.radius - kPalm.radius >= kFinger.radius + 0.004 - 1e-12);
}

RC_GTEST_PROP(WallHold, BallsNeverPassBetweenWheelAndRimNorOnTheAxisFarSide, ()) {
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  const ClayView clay = wall(metres(20, 120), metres(20, 120));
  const Grip grip = *rc::gen::element(Grip::both, Grip::outside, Grip::inside);
  WallHold hold(kPalm, kFinger);
  const double height = metres(0, 220);
  hold.take(clay, grip, height);
  const double at = std::clamp(height, hold.lowest(clay), hold.highest(clay));
  const auto hands = hold.stand(clay, metres(0, 150), at);
  for (const WallHold::Stand& ball : {hands.outside, hands.inside}) {
    if (!ball.there) continue;
    RC_ASSERT(ball.radius >= 0.0);
    RC_ASSERT(ball.height <= clay.rim_height() + ball.part.radius + 1e-9);
    RC_ASSERT(ball.height >= -ball.part.radius - 1e-9);
  }
}

}  // namespace
}  // namespace onggi::device::wall_hold_test
