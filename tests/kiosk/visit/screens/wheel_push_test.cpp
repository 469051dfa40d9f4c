// A wheel that is turned by its head.
#include "kiosk/visit/screens/wheel_push.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kiosk/visit/screens/wheel_speed.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::wheel_push_test {
namespace {

using view::InputEvent;
using Takes = WheelPush::Takes;

constexpr double kRadius = 0.15;

struct Hand {
  Hand() {
    ClayDef low;  // a floor to build on
    low.height = low.floor_thickness = 0.010;
    low.outer_radius = 0.06;
    clay.lay(low);
  }
  ClayView clay;
  view::Camera camera = view::frame_pot(1280, 720, {340, 60, 600, 600}, 0.2, 0.1);
  WheelPush push;
  InputEvent event(InputEvent::Kind kind, Vec3 at) const {
    const auto pixel = *camera.project(at);
    return {kind, pixel.first, pixel.second, 0, view::Key::none, false};
  }
  /// On the wheel head in front, `turned` rad from the middle, from x towards z.
  Vec3 front(double turned) const {
    Vec3 right, up, back;
    camera.basis(right, up, back);
    const double angle = std::atan2(back.z, back.x) + turned;
    return {0.12 * std::cos(angle), 0.0, 0.12 * std::sin(angle)};
  }
  Takes down(Vec3 at) {
    return push.pointer(event(InputEvent::Kind::pointer_down, at), camera, kRadius, clay);
  }
  Takes move(Vec3 at) {
    return push.pointer(event(InputEvent::Kind::pointer_move, at), camera, kRadius, clay);
  }
  Takes up() {
    return push.pointer(event(InputEvent::Kind::pointer_up, {0, 0, 0}), camera, kRadius, clay);
  }
};

TEST(WheelPush, AFingerTurnsTheWheelAsFastAsItGoesRoundEitherWay) {
  for (const double rad_per_s : {2.0, -2.0}) {
    Hand hand;
    ASSERT_EQ(hand.down(hand.front(-0.2 * rad_per_s)), Takes::wheel);
    std::optional<double> speed;
    for (double t = 0.0; t < 0.4; t += 0.016) {
      EXPECT_EQ(hand.move(hand.front(rad_per_s * (t - 0.2))), Takes::wheel);
      speed = hand.push.speed(0.016);
    }
    ASSERT_TRUE(speed);
    EXPECT_NEAR(*speed, rad_per_s, 0.1);
    EXPECT_EQ(hand.up(), Takes::wheel);
    EXPECT_FALSE(hand.push.speed(0.016));
  }
}

TEST(WheelPush, ATapIsNoPush) {
  Hand hand;
  hand.down(hand.front(0.0));
  hand.move(hand.front(0.05));
  EXPECT_FALSE(hand.push.speed(0.016));
}

// At ten frames a second a finger's last frame has no report, and the wheel stood after each push.
TEST(WheelPush, AFrameWithoutAReportIsNoStop) {
  Hand hand;
  hand.down(hand.front(-0.4));
  for (int n = 1; n <= 4; ++n) {
    hand.move(hand.front(-0.4 + 0.2 * n));
    hand.push.speed(0.1);
  }
  EXPECT_NEAR(*hand.push.speed(0.1), 2.0, 0.2);
}

TEST(WheelPush, AFingerThatHoldsStillHoldsTheWheel) {
  Hand hand;
  hand.down(hand.front(0.0));
  hand.move(hand.front(0.3));
  for (int n = 0; n < 30; ++n) hand.push.speed(0.016);
  EXPECT_NEAR(*hand.push.speed(0.016), 0.0, 1e-3);
}

TEST(WheelPush, AFingerThatGoesUpOntoThePotIsNotTheWheels) {
  Hand hand;
  ASSERT_EQ(hand.down(hand.front(0.0)), Takes::wheel);
  EXPECT_EQ(hand.move({0.0, 0.1, 0.0}), Takes::lets_go);
  EXPECT_EQ(hand.move({0.0, 0.12, 0.0}), Takes::nothing);
}

TEST(WheelPush, PotFootAndTableAreNotTheWheelHead) {
  for (const Vec3 at :
       {Vec3{0.05, 0.02, 0.0}, {0.06, 0.0, 0.0}, {-0.06, 0.0, 0.0}, {0.0, 0.1, 0.0}}) {
    Hand hand;
    EXPECT_EQ(hand.down(at), Takes::nothing) << at.x << ", " << at.y;
  }
  Hand hand;
  Vec3 far = hand.front(0.0);
  far.x *= 1.9, far.z *= 1.9;
  EXPECT_EQ(hand.down(far), Takes::nothing);
}

// A visitor held the coil on the front edge of the floor, as the words said, and nothing came.
TEST(WheelPush, TheFrontOfTheClayIsTheClays) {
  for (const double share : {0.0, 0.5, 0.9, 1.0})
    for (const double height : {0.0, 0.005, 0.010}) {
      Hand hand;
      Vec3 at = hand.front(0.2);
      at.x *= share * 0.06 / 0.12, at.z *= share * 0.06 / 0.12, at.y = height;
      EXPECT_EQ(hand.down(at), Takes::nothing) << share << ", " << height;
    }
}

TEST(WheelPush, TheSideOfTheWheelHeadAsThePictureShowsItIsTheWheels) {
  Hand hand;
  Vec3 at = hand.front(0.0);
  at.x *= 0.15 / 0.12, at.z *= 0.15 / 0.12, at.y = -0.012;
  EXPECT_EQ(hand.down(at), Takes::wheel);
}

/// A visitor at the wheel, and the wheel head as they see it.
struct AtTheWheel : Visitor {
  AtTheWheel() {
    throw_a_pot();
    frames(2);
  }
  Vec3 front(double turned) const {
    Vec3 right, up, back;
    frame.pot->camera.basis(right, up, back);
    const double angle = std::atan2(back.z, back.x) + turned, out = 0.9 * frame.pot->wheel_radius;
    return {out * std::cos(angle), 0.0, out * std::sin(angle)};
  }
  void swipe(double rad_per_s) {
    bool first = true;
    for (double t = -0.2; t < 0.2; t += 1.0 / 30, first = false) {
      const auto at = *frame.pot->camera.project(front(rad_per_s * t));
      first ? down(at.first, at.second) : move(at.first, at.second);
      frames(1.0 / 30);
    }
    const auto at = *frame.pot->camera.project(front(0.2 * rad_per_s));
    up(at.first, at.second);
    show();
  }
  double speed() const { return wheel_commands.wheels.back(); }
};

TEST(WheelPush, AWheelThatIsPushedRunsDownAndTheButtonStartsItsMotorAgain) {
  AtTheWheel v;
  const double motor = v.speed();
  v.frames(3);
  EXPECT_EQ(v.speed(), motor) << "a motor holds its speed";
  v.swipe(3.0);
  EXPECT_NEAR(v.speed(), 3.0, 0.6);
  EXPECT_TRUE(v.wheel_commands.hands.empty() || !v.wheel_commands.hands.back().active)
      << "the clay is not touched";
  const double pushed = v.speed();
  v.frames(4);
  EXPECT_LT(v.speed(), pushed - 0.5);
  EXPECT_GT(v.speed(), 0.3);
  v.touch("throw.wheel");
  v.touch("throw.faster");
  const double again = v.speed();
  v.frames(3);
  EXPECT_LT(v.speed(), again) << "a push, and no motor";
  v.frames(40);
  EXPECT_EQ(v.speed(), 0.0);
  v.touch("throw.faster");
  v.frames(10);
  EXPECT_EQ(v.speed(), WheelSpeed::kStep) << "the motor";
}

TEST(WheelPush, AgainstItsTurnAHandBrakesTheWheel) {
  AtTheWheel v;
  v.swipe(-3.0);
  EXPECT_EQ(v.speed(), 0.0);
  v.frames(3);
  EXPECT_NE(words_in(v.frame).find("has stopped"), std::string::npos);
}

TEST(WheelPush, OnAWheelThatStandsAButtonThatLaysARingStartsTheMotor) {
  AtTheWheel v;
  for (ShelfCard& card : v.shelf) {
    card.wheel.coil = 0.013;
    card.wheel.tools = {{0, "coil", 0.0065, 0.0065}};
    for (ProfilePoint& p : card.target.points) p.height *= 4.0;
  }
  v.touch("throw.tools");
  v.touch("throw.tool.1");
  v.frames(1);
  v.swipe(-3.0);
  ASSERT_EQ(v.speed(), 0.0);
  v.touch("throw.show");
  EXPECT_GT(v.speed(), 1.0);
}

}  // namespace
}  // namespace onggi::screens::wheel_push_test
