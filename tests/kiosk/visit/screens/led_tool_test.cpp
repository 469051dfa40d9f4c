#include "kiosk/visit/screens/led_tool.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/decorator.h"

// A hand device leads the tool on the screen Decorate.

namespace onggi::screens::led_tool_test {
namespace {

/// A visitor at the screen Decorate who holds a device.
struct Held : Decorator {
  Held() {
    touch("result.keep");
    status.hands_taken = true;
    frames(0.2);
    status.leather = wheel_commands.wall != nullptr;
  }
  /// The tool is `depth` (m) in the wall at `along`, at the front of the pot.
  void at(double along, double depth, double turns = 0.0) {
    const Vec3 eye = frame.pot->camera.eye();
    const double front = (std::atan2(eye.z, eye.x) - frame.pot->clay_angle) / 6.283185307179586;
    const double round = front + turns;
    status.at_leather[0] = {true, depth > 0.0, along, round - std::floor(round), depth};
    show();
  }
};

TEST(LedTool, WithoutADeviceTheClayIsAsItWas) {
  Decorator v;
  v.touch("result.keep");
  v.frames(1);
  v.stroke(20, 40);
  EXPECT_EQ(v.wheel_commands.wall, nullptr);
  EXPECT_EQ(v.wheel_commands.decorating.law, force::DecoratingLaw::none);
}

TEST(LedTool, TheOutlineThatADeviceFeelsIsThatOfThePotOnTheScreen) {
  Held v;
  ASSERT_NE(v.wheel_commands.wall, nullptr);
  const auto& surface = v.pot()->surface();
  for (int row = 4; row < surface.rows() - 4; row += 7) {
    const surface::Row& is = surface.row(row);
    const double along = 2.5e-4 * (row + 0.5);
    const auto near = v.wheel_commands.wall->near({is.radius, is.height, 0.0}, along, 0.002);
    EXPECT_LT(std::fabs(near.depth), 2e-4) << row;
    EXPECT_NEAR(near.along, along, 5e-4) << row;
  }
  EXPECT_EQ(v.wheel_commands.decorating.law, force::DecoratingLaw::cut);
  EXPECT_NEAR(v.wheel_commands.turned.angle, v.frame.pot->clay_angle, 1e-9);
}

TEST(LedTool, TouchingTheWallGoingAlongItAndLeavingItIsAStroke) {
  Held v;
  const auto empty = v.frame.items.size();
  v.at(0.05, -0.004);
  EXPECT_GT(v.frame.items.size(), empty) << "its finger is seen before it touches";
  EXPECT_FALSE(v.pot()->pressed());
  EXPECT_TRUE(v.pot()->bare());
  for (int n = 0; n <= 10; ++n) v.at(0.05 + 0.002 * n, 4e-4);
  EXPECT_TRUE(v.pot()->pressed());
  v.at(0.07, -0.004);
  EXPECT_FALSE(v.pot()->pressed());
  v.frames(1);
  ASSERT_EQ(v.pot()->did().size(), 1u);
  EXPECT_EQ(v.pot()->did()[0].times, 1);
  EXPECT_TRUE(v.pot()->touched(0.055, 0.065));
  EXPECT_FALSE(v.pot()->touched(0.02, 0.04));
}

TEST(LedTool, AnotherToolDrawsOnlyOnceTheHandWasOffTheWall) {
  Held v;
  v.at(0.05, 4e-4);
  ASSERT_TRUE(v.pot()->pressed());
  v.touch("decorate.tool.1");
  v.at(0.06, 4e-4);
  EXPECT_FALSE(v.pot()->pressed());
  v.at(0.06, -0.002);
  v.at(0.06, 4e-4);
  EXPECT_TRUE(v.pot()->pressed() || v.pot()->busy());
}

TEST(LedTool, AfterTheScreenTheClayIsSoftAgain) {
  Held v;
  ASSERT_NE(v.wheel_commands.wall, nullptr);
  v.touch("decorate.on");
  v.frames(0.5);
  EXPECT_EQ(v.wheel_commands.wall, nullptr);
}

}  // namespace
}  // namespace onggi::screens::led_tool_test
