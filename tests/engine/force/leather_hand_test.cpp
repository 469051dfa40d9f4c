#include "engine/force/leather_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace onggi::force::leather_hand_test {
namespace {

constexpr DecoratingTool kNeedle{DecoratingLaw::cut, 1e-3, 5e-4, 0.0, 0.5};

/// A cylinder of 60 mm radius, 150 mm high, with a wall of 6 mm.
LeatherOutline cylinder() {
  return LeatherOutline({{0.06, 0.0}, {0.06, 0.15}, {0.054, 0.15}, {0.054, 0.01}, {0.01, 0.01}});
}

TEST(LeatherOutline, TellsHowDeepAPlaceIsAndWhichWayIsOut) {
  const LeatherOutline wall = cylinder();
  const NearWall off = wall.near({0.062, 0.08, 0.0});
  EXPECT_NEAR(off.depth, -0.002, 1e-12);
  EXPECT_NEAR(off.along, 0.08, 1e-12);
  const NearWall in = wall.near({0.0, 0.08, 0.059});
  EXPECT_NEAR(in.depth, 0.001, 1e-12);
  EXPECT_NEAR(length(in.out - Vec3{0.0, 0.0, 1.0}), 0.0, 1e-9);
  const NearWall inside = wall.near({-0.055, 0.08, 0.0});
  EXPECT_NEAR(inside.depth, 0.001, 1e-12);
  EXPECT_NEAR(length(inside.out - Vec3{1.0, 0.0, 0.0}), 0.0, 1e-9) << "towards the axis";
  EXPECT_NEAR(inside.along, 0.15 + 0.006 + 0.07, 1e-12);
  EXPECT_NEAR(wall.near({0.057, 0.152, 0.0}).depth, -0.002, 1e-12) << "over the lip";
  EXPECT_NEAR(wall.near({0.03, 0.009, 0.0}).depth, 0.001, 1e-12) << "in the floor";
}

TEST(LeatherOutline, ItsDepthFallsAsFastAsItsWayOutSaysEverywhere) {
  // Else a closed path would gain by it. A belly of short stretches, as a pot has.
  std::vector<Vec2> corners;
  for (int n = 0; n <= 150; ++n) corners.push_back({0.05 + 0.02 * std::sin(0.02 * n), 0.001 * n});
  const LeatherOutline wall(corners);
  constexpr double kStep = 1e-6;
  for (int n = 3; n < 140; ++n)
    for (const double off : {-0.002, -0.0004, 0.0003, 0.002}) {
      const Vec3 at{0.05 + 0.02 * std::sin(0.02 * n) - off, 0.001 * n + 0.00037, 0.0};
      const NearWall here = wall.near(at);
      const double there = wall.near(at + kStep * here.out).depth;
      EXPECT_NEAR((here.depth - there) / kStep, 1.0, 1e-3) << n << ' ' << off;
      EXPECT_NEAR(length(here.out), 1.0, 1e-9);
    }
}

TEST(LeatherOutline, WhatIsNoCornerIsLeftOutAndLessThanTwoAreNoWall) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(LeatherOutline({}).stands());
  EXPECT_FALSE(LeatherOutline({{0.06, 0.0}, {0.06, 0.0}, {kNone, 0.1}}).stands());
  const LeatherOutline wall({{0.06, 0.0}, {kNone, 0.1}, {0.06, 0.15}});
  EXPECT_TRUE(wall.stands());
  EXPECT_NEAR(wall.near({0.059, 0.1, 0.0}).depth, 0.001, 1e-12);
  EXPECT_LT(LeatherOutline({}).near({}).depth, -1.0);
}

TEST(LeatherOutline, CornersMayLieFartherAlongThanTheyAreApart) {
  // As where an outline of even rows goes round an edge.
  const LeatherOutline wall({{0.06, 0.0}, {0.06, 0.001}, {0.0595, 0.0015}}, 0.0005, 0.001);
  EXPECT_NEAR(wall.near({0.061, 0.0005, 0.0}).along, 0.001, 1e-12);
  EXPECT_NEAR(wall.near({0.0595, 0.01, 0.0}).along, 0.0025, 1e-12);
}

TEST(LeatherHand, AToolThatComesFromOutsideIsPushedOutAndItsPlaceIsTold) {
  const LeatherOutline wall = cylinder();
  LeatherHand hand;
  const LeatherTurn turn{0.5, 2.0};
  EXPECT_EQ(hand.meet(wall, kNeedle, {0.061, 0.08, 0.0}, 1.0, turn).push, Vec3{});
  EXPECT_TRUE(hand.place().near);
  EXPECT_FALSE(hand.place().contact);
  const Touch touch = hand.meet(wall, kNeedle, {0.0597, 0.08, 0.0}, 1.0, turn);
  EXPECT_TRUE(hand.place().contact);
  EXPECT_NEAR(hand.place().along, 0.08, 1e-9);
  EXPECT_NEAR(hand.place().depth, 3e-4, 1e-9);
  EXPECT_NEAR(hand.place().turns, 1.0 - 0.5 / 6.283185307179586, 1e-12);
  const ToolPress press = press_of(kNeedle, hand.place().depth);
  EXPECT_NEAR(touch.push.x, press.push, 1e-12);
  EXPECT_EQ(touch.grip, press.grip);
  EXPECT_NEAR(touch.clay.z, 2.0 * 0.0597, 1e-12) << "the pot turns from x towards z";
  const Touch half = hand.meet(wall, kNeedle, {0.0597, 0.08, 0.0}, 0.5, turn);
  EXPECT_NEAR(half.push.x, 0.5 * press.push, 1e-12);
  EXPECT_NEAR(half.grip, 0.5 * press.grip, 1e-12);
}

TEST(LeatherHand, AHandThatArrivesInTheClayIsNotThrownOut) {
  const LeatherOutline wall = cylinder();
  LeatherHand hand;
  for (const double radius : {0.057, 0.058, 0.059}) {
    EXPECT_EQ(hand.meet(wall, kNeedle, {radius, 0.08, 0.0}, 1.0, {}).push, Vec3{}) << radius;
    EXPECT_FALSE(hand.place().contact);
  }
  hand.meet(wall, kNeedle, {0.0605, 0.08, 0.0}, 1.0, {});
  EXPECT_GT(hand.meet(wall, kNeedle, {0.0595, 0.08, 0.0}, 1.0, {}).push.x, 0.0);
  hand.release();
  EXPECT_EQ(hand.meet(wall, kNeedle, {0.058, 0.08, 0.0}, 1.0, {}).push, Vec3{});
}

TEST(LeatherHand, AToolThatIsPushedPastTheMiddleOfTheWallStaysAtItsFace) {
  const LeatherOutline wall = cylinder();
  LeatherHand hand;
  for (double radius = 0.061; radius > 0.0545; radius -= 1e-4) {
    const Touch touch = hand.meet(wall, kNeedle, {radius, 0.08, 0.0}, 1.0, {});
    if (radius < 0.0599) {
      EXPECT_GT(touch.push.x, 0.0) << radius;
    }
  }
  for (double radius = 0.0545; radius > 0.02; radius -= 1e-4)
    hand.meet(wall, kNeedle, {radius, 0.08, 0.0}, 1.0, {});
  EXPECT_FALSE(hand.place().contact) << "far through, it is let go";
}

TEST(LeatherHand, WithoutAWallAToolOrANumberNothingIsMet) {
  LeatherHand hand;
  const LeatherOutline wall = cylinder();
  EXPECT_EQ(hand.meet(LeatherOutline({}), kNeedle, {0.06, 0.08, 0.0}, 1.0, {}).push, Vec3{});
  hand.meet(wall, {}, {0.061, 0.08, 0.0}, 1.0, {});
  EXPECT_EQ(hand.meet(wall, {}, {0.0595, 0.08, 0.0}, 1.0, {}).push, Vec3{});
  EXPECT_FALSE(hand.place().near);
  hand.meet(wall, kNeedle, {0.061, 0.08, 0.0}, 1.0, {});
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hand.meet(wall, kNeedle, {none, 0.08, 0.0}, 1.0, {}).push, Vec3{});
  EXPECT_FALSE(hand.place().contact);
}

}  // namespace
}  // namespace onggi::force::leather_hand_test
