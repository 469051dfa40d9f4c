#include "kiosk/wheel/device/pointer_lead.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::device::pointer_lead_test {
namespace {

constexpr WallHold::Part kPalm{2, 0.018}, kFinger{0, 0.008};
constexpr Vec3 kRight{1, 0, 0};
constexpr double kFrame = 1.0 / 60;

ClayView lump() {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  ClayView clay;
  clay.lay(def);
  return clay;
}

void let_pass(PointerLead& hand, const ClayView& clay, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / kFrame)); ++i)
    hand.follow(clay, kFrame, true);
}

TEST(PointerLead, GoingDownJustTouchesTheChosenFaceAtThePointersHeight) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.03, 0.12}, clay, Grip::outside);
  EXPECT_NEAR(hand.reach(), 0.055, 1e-6);
  EXPECT_NEAR(hand.height(), 0.12, 1e-9);
  EXPECT_NEAR(hand.input(kRight)[0].position.x, 0.055 + kPalm.radius, 1e-6);
  hand.grab({-0.03, 0.12}, clay, Grip::inside);
  const HandInput inside = hand.input(kRight)[0];
  EXPECT_EQ(inside.side, SideWish::inside);
  EXPECT_NEAR(inside.position.x, -(0.022 - kPalm.radius), 1e-6);
}

TEST(PointerLead, WithBothHandsTheWallIsBetweenThem) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.05, 0.12}, clay, Grip::both);
  const auto hands = hand.input(kRight);
  ASSERT_TRUE(hands[0].active && hands[1].active);
  EXPECT_EQ(hands[0].side, SideWish::outside);
  EXPECT_EQ(hands[1].side, SideWish::inside);
  EXPECT_NEAR(hands[0].position.x - hands[1].position.x, 0.055 - 0.022 + 2 * kPalm.radius, 1e-6);
}

RC_GTEST_PROP(PointerLead, TheFaceComesToBeWhereThePointerStays, ()) {
  const ClayView clay = lump();
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  PointerLead hand(kPalm, kFinger);
  hand.grab({metres(20, 90), metres(20, 180)}, clay, Grip::both);
  const double x = metres(20, 90), y = metres(20, 180);
  hand.drag({x, y});
  let_pass(hand, clay, 8);
  RC_ASSERT(std::abs(hand.reach() - x) < 1e-9);
  RC_ASSERT(std::abs(hand.height() - y) < 1e-9);
  RC_ASSERT(hand.behind() < 1e-9);
}

/// The least radius that was wanted of the face while `hand` follows a drag from `from` to `to`.
double least_reach(Vec2 from, Vec2 to, double rest) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab(from, clay, Grip::both);
  double least = hand.reach();
  for (int n = 0; n <= 30; ++n) {
    const double share = n / 30.0;
    hand.drag({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    hand.follow(clay, kFrame, true);
    least = std::min(least, hand.reach());
  }
  for (double t = 0; t < rest; t += kFrame) {
    hand.follow(clay, kFrame, true);
    least = std::min(least, hand.reach());
  }
  return least;
}

TEST(PointerLead, AFingerThatCrossesTheFrontOfThePotOnlyTouchesItUntilItRestsOrWorksTheWall) {
  EXPECT_NEAR(least_reach({-0.02, 0.0}, {0.06, 0.04}, 0), 0.055, 1e-4) << "out to the line";
  EXPECT_NEAR(least_reach({0.03, 0.08}, {-0.03, 0.08}, 0), 0.055, 1e-4) << "from side to side";
  EXPECT_LT(least_reach({-0.02, 0.08}, {0.04, 0.08}, 2), 0.05) << "it rests in the clay";
  EXPECT_LT(least_reach({0.04, 0.04}, {0.04, 0.12}, 0), 0.05) << "it goes up along the wall";
}

TEST(PointerLead, HandsThatChangeSidesAreOffTheClayMeanwhile) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({-0.01, 0.0}, clay, Grip::both);
  EXPECT_LT(hand.input(kRight)[0].position.x, 0);
  hand.drag({0.01, 0.0});
  EXPECT_FALSE(hand.input(kRight)[0].active) << "or they would go through the pot";
  let_pass(hand, clay, 0.1);
  EXPECT_TRUE(hand.input(kRight)[0].active);
  EXPECT_GT(hand.input(kRight)[0].position.x, 0);
}

TEST(PointerLead, AStrokeDrawnInATenthOfASecondIsFollowedAtAPottersPaceCornersAndAll) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.055, 0.05}, clay, Grip::both);
  hand.drag({0.055, 0.15});
  hand.drag({0.045, 0.15});
  hand.release();
  double highest = 0, last = hand.height();
  bool cut = false;
  while (hand.active()) {
    hand.follow(clay, kFrame, true);
    if (!hand.active()) break;
    EXPECT_LE(std::abs(hand.height() - last), PointerLead::kRise * kFrame * (1 + 1e-9));
    last = hand.height();
    highest = std::max(highest, last);
    cut = cut || (hand.reach() < 0.0549 && hand.height() < 0.1499);
  }
  EXPECT_GE(highest, 0.15);
  EXPECT_LE(highest, 0.15 + WallPass::kOut);
  EXPECT_FALSE(cut);
}

TEST(PointerLead, WhatWasDrawnIsFinishedWhenThePointerLiftsButNotForEver) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.055, 0.05}, clay, Grip::both);
  for (int n = 0; n < 20; ++n) hand.drag({0.055, n % 2 == 0 ? 0.15 : 0.05});
  hand.release();
  EXPECT_TRUE(hand.active());
  EXPECT_FALSE(hand.grabbed());
  let_pass(hand, clay, PointerLead::kFinish - 0.1);
  EXPECT_TRUE(hand.active());
  let_pass(hand, clay, 0.2);
  EXPECT_FALSE(hand.active());
}

TEST(PointerLead, AStrokeThatEndsOnTheWallRunsOutOfItAndLeavesNoStep) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.055, 0.05}, clay, Grip::both);
  for (int n = 1; n <= 120; ++n) {
    hand.drag({0.055 + 0.0001 * n, 0.05 + 0.0004 * n});
    hand.follow(clay, kFrame, true);
  }
  EXPECT_GT(hand.reach(), 0.062);
  hand.release();
  double height = 0, reach = 0;
  for (int n = 0; n < 120 && hand.active(); ++n) {
    height = hand.height();
    reach = hand.reach();
    hand.follow(clay, kFrame, true);
  }
  EXPECT_FALSE(hand.active());
  EXPECT_GT(height, 0.05 + 0.048 + 0.010) << "on along the wall";
  EXPECT_NEAR(reach, 0.055, 5e-4);
}

// A pointer that runs to and fro far beside the wall does not carry the wall along.
TEST(PointerLead, AScrubBesideTheWallLeavesItAboutWhereItStood) {
  ClayDef thin;
  thin.rows = 100;
  thin.sectors = 16;
  thin.inner_radius = 0.050;
  ClayView clay;
  clay.lay(thin);
  for (const double beside : {-0.03, 0.04}) {
    PointerLead hand(kPalm, kFinger);
    hand.grab({0.055, 0.1}, clay, Grip::both);
    double farthest = 0;
    for (int n = 0; n < 480; ++n) {
      hand.drag({0.055 + beside, 0.1 + 0.04 * std::sin(0.02 * n)});
      hand.follow(clay, kFrame, true);
      farthest = std::max(farthest, std::abs(hand.reach() - 0.055));
      EXPECT_NEAR(hand.input(kRight)[0].position.x, hand.reach() + kPalm.radius, 1e-9);
    }
    EXPECT_GT(farthest, WallPass::kDeepest - 1e-6) << beside;
    EXPECT_LT(farthest, WallPass::kDeepest + 0.006) << beside << ": they press on where they turn";
  }
}

TEST(PointerLead, AHandFarBehindHurries) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.055, 0.05}, clay, Grip::both);
  for (int n = 0; n < 40; ++n) hand.drag({0.055, n % 2 == 0 ? 0.15 : 0.05});
  EXPECT_GT(hand.behind(), 30);
  let_pass(hand, clay, 20);
  EXPECT_LT(hand.behind(), PointerLead::kBehind);
}

TEST(PointerLead, APokeAtTheSolidFootLeavesLittle) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.055, 0.006}, clay, Grip::both);
  double least = 1;
  for (int n = 0; n <= 12; ++n) {  // A fifth of a second in and out, 30 mm deep.
    hand.drag({0.055 - 0.005 * std::min(n, 12 - n), 0.006});
    hand.follow(clay, kFrame, true);
    least = std::min(least, hand.reach());
  }
  for (int n = 0; n < 60; ++n) {  // The pointer is back, and the hand does not make up for it.
    hand.follow(clay, kFrame, true);
    least = std::min(least, hand.reach());
  }
  EXPECT_GT(least, 0.055 - 0.0025);
}

RC_GTEST_PROP(PointerLead, TheWorkStaysBetweenTheWheelAndTheRim, ()) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  const Grip grip = *rc::gen::element(Grip::both, Grip::outside, Grip::inside);
  const auto metres = [] { return *rc::gen::inRange(-1000, 1000) / 1000.0; };
  hand.grab({metres(), metres()}, clay, grip);
  for (int i = 0; i < 5; ++i) {
    hand.drag({metres(), metres()});
    hand.follow(clay, 0.5, true);
    RC_ASSERT(hand.height() > 0.0);
    RC_ASSERT(hand.height() <= 0.2 + kPalm.radius);
    RC_ASSERT(hand.reach() >= 0.0);
    if (grip == Grip::inside) RC_ASSERT(hand.height() > 0.01);
    if (grip == Grip::both) RC_ASSERT(hand.height() < 0.2);
  }
}

TEST(PointerLead, TheWheelOfAMouseSetsTheReachOffForTheRestOfTheStroke) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.grab({0.055, 0.1}, clay, Grip::outside);
  hand.move(-0.004, 0);
  hand.drag({0.055, 0.12});
  let_pass(hand, clay, 2);
  EXPECT_NEAR(hand.reach(), 0.051, 1e-9);
  EXPECT_NEAR(hand.height(), 0.12, 1e-9);
}

TEST(PointerLead, KeysWorkUntilTheHandIsLiftedAndLiftingTakesItAway) {
  const ClayView clay = lump();
  PointerLead hand(kPalm, kFinger);
  hand.begin_by_keys(clay, Grip::both, -1);
  EXPECT_LT(hand.input(kRight)[0].position.x, 0);
  hand.move(-0.002, 0);
  let_pass(hand, clay, 3);
  EXPECT_TRUE(hand.input(kRight)[0].active);
  EXPECT_NEAR(hand.reach(), 0.053, 1e-6);
  hand.lift();
  for (const HandInput& each : hand.input(kRight)) EXPECT_FALSE(each.active);
}

}  // namespace
}  // namespace onggi::device::pointer_lead_test
