#include "kiosk/wheel/device/pointer_hand.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace onggi::device::pointer_hand_test {
namespace {

HandInput at(double x, bool active = true) {
  HandInput hand;
  hand.position = {x, 0.1, 0};
  hand.active = active;
  return hand;
}

TEST(PointerHand, AToolSetDownStandsWhereThePointerIsAtOnce) {
  PointerHand hand;
  hand.lead(at(0.3, false));
  hand.read(1e-3);
  hand.lead(at(0.07));
  EXPECT_EQ(hand.read(1e-3), at(0.07));
}

TEST(PointerHand, ALedToolGlidesNoFasterThanAHandAndNeverPastThePointer) {
  EXPECT_TRUE(rc::check([] {
    const PointerHandDef def;
    PointerHand hand(def);
    double x = *rc::gen::inRange(-200, 200) * 1e-3;
    const double goal = *rc::gen::inRange(-200, 200) * 1e-3;
    hand.lead(at(x));
    hand.read(1e-3);
    hand.lead(at(goal));
    for (int i = 0; i < 300; ++i) {
      const double dt = *rc::gen::inRange(1, 6) * 1e-3;
      const double next = hand.read(dt).position.x;
      RC_ASSERT(std::abs(next - x) <= def.max_speed * dt * (1 + 1e-12));
      RC_ASSERT((goal - next) * (goal - x) >= 0);  // Not past the goal.
      RC_ASSERT(std::abs(goal - next) <= std::abs(goal - x));
      x = next;
    }
  }));
}

TEST(PointerHand, ItArrivesWithinATenthOfAMillimetreInASecond) {
  PointerHand hand;
  hand.lead(at(0));
  hand.read(1e-3);
  hand.lead(at(0.2));
  double x = 0;
  for (int i = 0; i < 1000; ++i) x = hand.read(1e-3).position.x;
  EXPECT_NEAR(x, 0.2, 1e-4);
}

TEST(PointerHand, WhatIsHeldAndHowPassesThroughAtOnceWhileTheToolStillGlides) {
  PointerHand hand;
  hand.lead(at(0.05));
  hand.read(1e-3);
  HandInput rib = at(0.07);
  rib.side = SideWish::inside;
  rib.tool = 3;
  rib.handle = {0.2, 0.9, 0.1};
  rib.roll = 0.4;
  hand.lead(rib);
  const HandInput read = hand.read(1e-3);
  EXPECT_LT(read.position.x, 0.06);
  rib.position = read.position;
  EXPECT_EQ(read, rib);
}

TEST(PointerHand, AToolThatWasLiftedAndSetDownWithinATickDoesNotPloughOnItsWay) {
  PointerHand hand;
  hand.lead(at(0.05));
  hand.read(1e-3);
  hand.lead(at(0.05, false));
  hand.lead(at(-0.05));
  EXPECT_EQ(hand.read(1e-3), at(-0.05));
}

TEST(PointerHand, AToolLiftedInTheAirTouchesNothing) {
  PointerHand hand;
  hand.lead(at(0.05));
  for (int n = 0; n < 1000; ++n) hand.read(1e-3);
  hand.lead(at(0.05, false));
  EXPECT_FALSE(hand.read(1e-3).active);
}

HandFeedback touching() {
  HandFeedback felt;
  felt.contact = true;
  return felt;
}

TEST(PointerHand, InClayItKeepsToAPottersPace) {
  const PointerHandDef def;
  PointerHand hand(def);
  hand.lead(at(0.06));
  double x = hand.read(1e-3).position.x;
  HandInput goal = at(0.03);
  goal.position.y = 0.2;
  hand.lead(goal);
  double y = 0.1;
  for (int n = 0; n < 300; ++n) {
    hand.feel(touching());
    const Vec3 next = hand.read(1e-3).position;
    EXPECT_LE(std::abs(next.x - x), def.press_speed * 1e-3 * (1 + 1e-9));
    EXPECT_LE(std::abs(next.y - y), def.rise_speed * 1e-3 * (1 + 1e-9));
    x = next.x, y = next.y;
  }
  EXPECT_LT(x, 0.05);
}

TEST(PointerHand, LiftedFromClayItComesOffSlowlyAwayFromTheWallAndIsOffInTime) {
  for (const SideWish side : {SideWish::outside, SideWish::inside}) {
    const PointerHandDef def;
    PointerHand hand(def);
    HandInput down = at(0.06);
    down.side = side;
    hand.lead(down);
    hand.read(1e-3);
    hand.feel(touching());
    down.active = false;
    hand.lead(down);
    double x = 0.06;
    int still = 0;
    for (HandInput read = hand.read(1e-3); read.active; read = hand.read(1e-3), ++still) {
      ASSERT_LT(still, 1000);
      EXPECT_EQ(read.side, side);
      EXPECT_EQ(read.position.x > x, side == SideWish::outside);
      EXPECT_NEAR(read.position.x, x, 2e-5);
      x = read.position.x;
    }
    EXPECT_NEAR(still * 1e-3, def.letting_go, 0.01);
  }
}

}  // namespace
}  // namespace onggi::device::pointer_hand_test
