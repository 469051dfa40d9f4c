#include <gtest/gtest.h>

#include "tests/kiosk/screens/visitor.h"

// A finger on the picture of the pot, from pixels to the metres that the hand is led by.

namespace onggi::screens {
namespace {

constexpr double kTool = 0.008;

/// The hand outside as it was asked to be last.
const HandInput& outer(const Visitor& v) {
  for (auto hand = v.potter.hands.rbegin(); hand != v.potter.hands.rend(); ++hand)
    if (hand->active && hand->side == SideWish::outside) return *hand;
  return v.potter.hands.back();
}

TEST(Pointer, TheFaceComesToBeWhereTheFingerIsOnTheScreen) {
  Visitor v;
  v.throw_a_pot();
  v.frames(2);
  const view::Camera camera = v.frame.pot->camera;
  const auto on = [&](double x, double y) { return *camera.project({x, y, 0}); };
  const auto [x0, y0] = on(0.05, 0.1);
  const auto [x1, y1] = on(0.04, 0.12);
  v.down(x0, y0);
  EXPECT_NEAR(outer(v).position.x, 0.055 + kTool, 1e-6);
  EXPECT_NEAR(outer(v).position.y, 0.1, 1e-3);
  v.move(x1, y1);
  v.frames(1.5);
  EXPECT_NEAR(outer(v).position.x, 0.04 + kTool, 1e-4);
  EXPECT_NEAR(outer(v).position.y, 0.12, 1e-3);
  v.up(x1, y1);
  v.show();
  EXPECT_FALSE(v.potter.hands.back().active);
}

TEST(Pointer, AFingerSetDownElsewhereLiftsHandsThatStillFinishAStroke) {
  Visitor v;
  v.throw_a_pot();
  v.frames(2);
  const view::Camera camera = v.frame.pot->camera;
  const auto on = [&](double x, double y) { return *camera.project({x, y, 0}); };
  const auto [x0, y0] = on(0.05, 0.05);
  const auto [x1, y1] = on(0.05, 0.15);
  const auto [x2, y2] = on(-0.05, 0.1);
  v.down(x0, y0);
  v.move(x1, y1);
  v.up(x1, y1);
  v.show();
  ASSERT_TRUE(outer(v).active);
  const std::size_t before = v.potter.hands.size();
  v.down(x2, y2);
  bool lifted = false;
  for (std::size_t n = before; n < v.potter.hands.size(); ++n) {
    lifted = lifted || !v.potter.hands[n].active;
    EXPECT_TRUE(lifted || v.potter.hands[n].position.x > 0);
  }
  EXPECT_LT(outer(v).position.x, 0);
}

TEST(Pointer, AScrollNotchPressesTwoMillimetresFurther) {
  Visitor v;
  v.throw_a_pot();
  v.frames(1);
  const auto [x, y] = *v.frame.pot->camera.project({0.05, 0.1, 0});
  v.down(x, y);
  v.frames(1);
  const double before = outer(v).position.x;
  v.visit->input({view::InputEvent::Kind::scroll, x, y, 1, view::Key::none, false}, v.now);
  v.frames(1);
  EXPECT_NEAR(outer(v).position.x, before - 0.002, 1e-9);
}

}  // namespace
}  // namespace onggi::screens
