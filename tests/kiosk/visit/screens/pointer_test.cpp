#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

// A finger on the picture of the pot, from pixels to the metres that the hand is led by.

namespace onggi::screens::pointer_test {
namespace {

constexpr double kTool = 0.008;

/// The hand outside as it was asked to be last.
const HandInput& outer(const Visitor& v) {
  for (auto hand = v.wheel_commands.hands.rbegin(); hand != v.wheel_commands.hands.rend(); ++hand)
    if (hand->active && hand->side == SideWish::outside) return *hand;
  return v.wheel_commands.hands.back();
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
  EXPECT_TRUE(outer(v).active) << "out of the clay as it goes on";
  v.frames(1);
  EXPECT_FALSE(v.wheel_commands.hands.back().active);
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
  const std::size_t before = v.wheel_commands.hands.size();
  v.down(x2, y2);
  bool lifted = false;
  for (std::size_t n = before; n < v.wheel_commands.hands.size(); ++n) {
    lifted = lifted || !v.wheel_commands.hands[n].active;
    EXPECT_TRUE(lifted || v.wheel_commands.hands[n].position.x > 0);
  }
  EXPECT_LT(outer(v).position.x, 0);
}

TEST(Pointer, AScrollNotchPressesTwoMillimetresFurther) {
  Visitor v;
  v.throw_a_pot();
  v.frames(1);
  const auto [x, y] = *v.frame.pot->camera.project({0.05, 0.1, 0});
  v.down(x, y);
  v.frames(4);
  const double before = outer(v).position.x;
  v.visit->input({view::InputEvent::Kind::scroll, x, y, 1, view::Key::none, false}, v.now);
  v.frames(4);
  EXPECT_NEAR(outer(v).position.x, before - 0.002, 1e-8);
}

/// Of the wall that both hands were last asked to hold between them, metres.
double held_wall(const Visitor& v, double radius) {
  double outside = 0, inside = 0;
  for (const HandInput& hand : v.wheel_commands.hands) {
    if (!hand.active) continue;
    (hand.side == SideWish::outside ? outside : inside) = hand.position.x;
  }
  return outside - radius - (inside + radius);
}

TEST(Pointer, TwoFingersThatCloseThinTheWallBetweenTheHands) {
  Visitor v;
  v.throw_a_pot();
  v.frames(2);
  const view::Camera camera = v.frame.pot->camera;
  const auto on = [&](double x, double y) { return *camera.project({x, y, 0}); };
  const auto finger = [&](view::InputEvent::Kind kind, int which, double x, double y) {
    const auto [px, py] = on(x, y);
    v.visit->input({.kind = kind, .x = px, .y = py, .finger = static_cast<std::uint8_t>(which)},
                   v.now);
    v.show();
  };
  using Event = view::InputEvent::Kind;
  finger(Event::pointer_down, 0, 0.055, 0.1);
  v.frames(1);
  const double alone = held_wall(v, kTool);
  EXPECT_NEAR(alone, 0.033, 1e-3);  // the lump's own wall
  finger(Event::pointer_down, 1, 0.015, 0.1);
  v.frames(1);
  EXPECT_NEAR(held_wall(v, kTool), alone, 1e-4);
  finger(Event::pointer_move, 1, 0.035, 0.1);  // Half as far: no more than a bite at a time.
  v.frames(1);
  EXPECT_NEAR(held_wall(v, kTool), alone - 0.002, 1e-4);
  finger(Event::pointer_move, 1, 0.016, 0.1);  // A fortieth closer.
  v.frames(1);
  EXPECT_NEAR(held_wall(v, kTool), alone * 39 / 40, 1e-4);
  finger(Event::pointer_up, 1, 0.016, 0.1);
  v.frames(1);
  EXPECT_NEAR(held_wall(v, kTool), alone, 1e-4);
}

TEST(Pointer, AFingerBesideTheFirstPressesNoButtonAndEndsNoScreen) {
  Visitor v;
  v.throw_a_pot();
  v.frames(2);
  for (const auto& [name, rect] : v.visit->controls())
    for (const auto kind :
         {view::InputEvent::Kind::pointer_down, view::InputEvent::Kind::pointer_up})
      v.visit->input({.kind = kind, .x = rect.x + 3, .y = rect.y + 3, .finger = 1}, v.now);
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  EXPECT_TRUE(v.wheel_commands.waters.empty() || !v.wheel_commands.waters.back());
}

}  // namespace
}  // namespace onggi::screens::pointer_test
