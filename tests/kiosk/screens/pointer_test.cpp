#include <gtest/gtest.h>

#include "tests/kiosk/screens/visitor.h"

// A finger on the picture of the pot, from pixels to the metres that the hand is led by.

namespace onggi::screens {
namespace {

constexpr double kTool = 0.008;

TEST(Pointer, ADragOnTheScreenPressesTheClayByTheMetresSeen) {
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

TEST(Pointer, AScrollNotchPressesTwoMillimetresFurther) {
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
