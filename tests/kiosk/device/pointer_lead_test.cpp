#include "kiosk/device/pointer_lead.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace onggi::device {
namespace {

constexpr double kTool = 0.008;
constexpr Vec3 kRight{1, 0, 0};

ClayView lump() {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  ClayView clay;
  clay.lay(def);
  return clay;
}

TEST(PointerLead, GoingDownJustTouchesTheChosenFaceAtThePointersHeight) {
  const ClayView clay = lump();
  PointerLead hand(kTool);
  hand.grab({0.03, 0.12}, clay, WallSide::outside);
  EXPECT_NEAR(hand.radius(), 0.055 + kTool, 1e-6);
  EXPECT_NEAR(hand.height(), 0.12, 1e-9);
  EXPECT_GT(hand.input(kRight).position.x, 0);
  hand.grab({-0.03, 0.12}, clay, WallSide::inside);
  EXPECT_NEAR(hand.radius(), 0.022 - kTool, 1e-6);
  EXPECT_LT(hand.input(kRight).position.x, 0);
  EXPECT_EQ(hand.input(kRight).side, SideWish::inside);
}

RC_GTEST_PROP(PointerLead, DraggingMovesTheToolAsFarAsThePointer, ()) {
  const ClayView clay = lump();
  const auto unit = [](int n) { return static_cast<double>(n) / 1000.0; };
  const double x = unit(*rc::gen::inRange(-90, 90)), y = unit(*rc::gen::inRange(20, 180));
  const double dx = unit(*rc::gen::inRange(-40, 40)), dy = unit(*rc::gen::inRange(-9, 9));
  PointerLead hand(kTool);
  hand.grab({x, y}, clay, WallSide::outside);
  const Vec3 before = hand.input(kRight).position;
  hand.drag({x + dx, y + dy});
  const Vec3 after = hand.input(kRight).position;
  RC_ASSERT(std::abs((after.x - before.x) - dx) < 1e-9);
  RC_ASSERT(std::abs((after.y - before.y) - dy) < 1e-9);
}

RC_GTEST_PROP(PointerLead, TheToolStaysBetweenTheWheelAndJustAboveTheRim, ()) {
  const ClayView clay = lump();
  PointerLead hand(kTool);
  const WallSide face = *rc::gen::arbitrary<bool>() ? WallSide::inside : WallSide::outside;
  const auto metres = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 1000.0; };
  hand.grab({metres(), metres()}, clay, face);
  for (int i = 0; i < 5; ++i) {
    hand.drag({metres(), metres()});
    RC_ASSERT(hand.height() >= kTool * 0.3 - 1e-12);
    RC_ASSERT(hand.height() <= 0.2 + kTool + 1e-12);
    RC_ASSERT(hand.radius() >= 0.0);
    if (face == WallSide::inside) RC_ASSERT(hand.height() > 0.01);
  }
}

TEST(PointerLead, LiftingTakesTheToolAway) {
  const ClayView clay = lump();
  PointerLead hand(kTool);
  hand.grab({0.05, 0.1}, clay, WallSide::outside);
  EXPECT_TRUE(hand.input(kRight).active);
  hand.lift();
  EXPECT_FALSE(hand.input(kRight).active);
}

}  // namespace
}  // namespace onggi::device
