#include "kiosk/screens/hand.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/kiosk/screens/visitor.h"

namespace onggi::screens {
namespace {

constexpr double kTool = 0.008;

loop::Mirror lump() {
  loop::Mirror clay;
  clay.reset(100, 16, 0.2, 0.01, 0.055, 0.022);
  return clay;
}

TEST(PotHand, GoingDownJustTouchesTheChosenFaceAtThePointersHeight) {
  const loop::Mirror clay = lump();
  PotHand hand(kTool);
  hand.grab({0.03, 0.12}, clay, WallSide::outside);
  EXPECT_NEAR(hand.radius(), 0.055 + kTool, 1e-6);
  EXPECT_NEAR(hand.height(), 0.12, 1e-9);
  EXPECT_GT(hand.input({}).position.x, 0);
  hand.grab({-0.03, 0.12}, clay, WallSide::inside);
  EXPECT_NEAR(hand.radius(), 0.022 - kTool, 1e-6);
  EXPECT_LT(hand.input({}).position.x, 0);
  EXPECT_EQ(hand.input({}).side, SideWish::inside);
}

RC_GTEST_PROP(PotHand, DraggingMovesTheToolAsFarAsThePointer, ()) {
  const loop::Mirror clay = lump();
  const auto unit = [](int n) { return static_cast<double>(n) / 1000.0; };
  const double x = unit(*rc::gen::inRange(-90, 90)), y = unit(*rc::gen::inRange(20, 180));
  const double dx = unit(*rc::gen::inRange(-40, 40)), dy = unit(*rc::gen::inRange(-9, 9));
  PotHand hand(kTool);
  hand.grab({x, y}, clay, WallSide::outside);
  const Vec3 before = hand.input({}).position;
  hand.drag({x + dx, y + dy});
  const Vec3 after = hand.input({}).position;
  RC_ASSERT(std::abs((after.x - before.x) - dx) < 1e-9);
  RC_ASSERT(std::abs((after.y - before.y) - dy) < 1e-9);
}

RC_GTEST_PROP(PotHand, TheToolStaysBetweenTheWheelAndJustAboveTheRim, ()) {
  const loop::Mirror clay = lump();
  PotHand hand(kTool);
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

TEST(PotHand, LiftingTakesTheToolAway) {
  const loop::Mirror clay = lump();
  PotHand hand(kTool);
  hand.grab({0.05, 0.1}, clay, WallSide::outside);
  EXPECT_TRUE(hand.input({}).active);
  hand.lift();
  EXPECT_FALSE(hand.input({}).active);
}

TEST(PotHand, ADragOnTheScreenPressesTheClayByTheMetresSeen) {
  Visitor v;
  v.throw_a_pot();
  v.frames(2);
  const view::Camera camera = v.frame.pot->camera;
  const auto on = [&](double x, double y) { return *camera.project({x, y, 0}); };
  const auto [x0, y0] = on(0.05, 0.1);
  const auto [x1, y1] = on(0.04, 0.1);
  v.down(x0, y0);
  const Vec3 touched = v.potter.hands.back().position;
  EXPECT_NEAR(touched.x, 0.055 + kTool, 1e-6);
  EXPECT_NEAR(touched.y, 0.1, 1e-3);
  v.move(x1, y1);
  EXPECT_NEAR(v.potter.hands.back().position.x, touched.x - 0.01, 1e-4);
  v.up(x1, y1);
  EXPECT_FALSE(v.potter.hands.back().active);
}

TEST(PotHand, AScrollNotchPressesTwoMillimetresFurther) {
  Visitor v;
  v.throw_a_pot();
  v.frames(1);
  const auto [x, y] = *v.frame.pot->camera.project({0.05, 0.1, 0});
  v.down(x, y);
  const double before = v.potter.hands.back().position.x;
  v.visit->input({view::InputEvent::Kind::scroll, x, y, 1, view::Key::none, false}, v.now);
  EXPECT_NEAR(v.potter.hands.back().position.x, before - 0.002, 1e-9);
}

}  // namespace
}  // namespace onggi::screens
