#include "kiosk/wheel/loop/wheel_view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"

namespace onggi::loop::wheel_view_test {
namespace {

void expect_the_view_is_the_clay(WheelHost& host) {
  ASSERT_TRUE(host.with_scene([&host](Scene& scene) {
    const Clay& clay = scene.clay();
    for (int j = 0; j < clay.rows(); ++j)
      for (int i = 0; i < clay.sectors(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        ASSERT_EQ(host.view().clay.outer(j)[at], clay.outer(j)[at]);
        ASSERT_EQ(host.view().clay.inner(j)[at], clay.inner(j)[at]);
      }
  }));
}

TEST(WheelView, WhatAHandPressesIntoTheClayReachesTheViewRowForRow) {
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.wheel(15);
  wheel_host.hand(0, press_at(def, 0.004));
  wheel_host.advance(800);
  wheel_host.hand(0, HandInput{});
  for (int i = 0; i < 30; ++i) {  // It comes off slowly.
    wheel_host.advance(20);
    wheel_host.collect();
  }
  EXPECT_LT(wheel_host.view().clay.radius_at(def.clay.height / 2, WallSide::outside),
            def.clay.outer_radius - 0.002);
  expect_the_view_is_the_clay(wheel_host);
}

TEST(WheelView, ARimThatIsPressedDownReachesTheView) {
  SteppedWheel wheel_host;
  SceneDef def = small_scene();
  def.clay.inner_radius = 0.049;
  wheel_host.start(pot(def));
  wheel_host.wheel(15);
  HandInput hand;
  hand.active = true;
  for (int n = 0; n < 60; ++n) {
    hand.position = {0.052, def.clay.height + def.tool.radius + 0.002 - n * 0.0001, 0};
    wheel_host.hand(0, hand);
    wheel_host.advance(20);
    wheel_host.collect();
  }
  wheel_host.hand(0, HandInput{});
  for (int i = 0; i < 30; ++i) {  // It comes off slowly.
    wheel_host.advance(20);
    wheel_host.collect();
  }
  EXPECT_LT(wheel_host.view().clay.rim_height(), def.clay.height - 0.001);
  expect_the_view_is_the_clay(wheel_host);
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) {
    const Profile shown = wheel_host.view().clay.profile();
    const Profile real = scene.clay().profile();
    ASSERT_EQ(shown.points.size(), real.points.size());
    for (std::size_t n = 0; n < real.points.size(); ++n) {
      EXPECT_EQ(shown.points[n].height, real.points[n].height);
      EXPECT_EQ(shown.points[n].outer, real.points[n].outer);
    }
  }));
}

/// A pot on which a rim press is under way, seen as it was some ticks ago.
void press_rim(SteppedWheel& wheel_host, SceneDef& def) {
  def.clay.inner_radius = 0.049;
  wheel_host.start(pot(def));
  wheel_host.wheel(15);
  for (int n = 0; n < 60; ++n) {
    HandInput hand;
    hand.active = true;
    hand.position = {0.052, def.clay.height + def.tool.radius + 0.002 - n * 0.0001, 0};
    wheel_host.hand(0, hand);
    wheel_host.advance(20);
    if (n < 50) wheel_host.collect();
  }
}

TEST(WheelView, ASettledViewIsTheClayToTheBitThoughRowsWereOnTheirWay) {
  SteppedWheel wheel_host;
  SceneDef def = small_scene();
  press_rim(wheel_host, def);
  const double before = wheel_host.view().clay.rim_height();
  ASSERT_TRUE(wheel_host.refresh_every_row());
  EXPECT_LT(wheel_host.view().clay.rim_height(), before) << "some were";
  expect_the_view_is_the_clay(wheel_host);
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) {
    const Profile seen = wheel_host.view().clay.profile(), real = scene.clay().profile();
    ASSERT_EQ(seen.points.size(), real.points.size());
    for (std::size_t n = 0; n < real.points.size(); ++n) {
      EXPECT_EQ(seen.points[n].height, real.points[n].height);
      EXPECT_EQ(seen.points[n].outer, real.points[n].outer);
      EXPECT_EQ(seen.points[n].inner, real.points[n].inner);
    }
  }));
  // What was on its way when it was settled does not come after it.
  wheel_host.advance(1);
  wheel_host.hand(0, HandInput{});
  for (int i = 0; i < 30; ++i) {  // It comes off slowly.
    wheel_host.advance(20);
    wheel_host.collect();
  }
  expect_the_view_is_the_clay(wheel_host);
}

TEST(WheelView, RowsThatOnlyMovedComeWithoutRadii) {
  SceneDef def = small_scene();
  def.volume.emplace();
  Scene scene = std::move(*Scene::create(def));
  ClayView before, view;
  before.take(scene.clay());
  RowChannel channel(def.clay.rows, def.clay.sectors);
  scene.mark_all_dirty();
  const auto send_all = [&] {
    while (channel.publish(scene, 16), channel.take_into(view) > 0) channel.ask();
    channel.ask();
  };
  view.lay(def.clay);
  send_all();
  // Where clay is kept, a low wall that is pressed grows thicker rows, and all above them rise.
  Hands hands;
  hands.wheel_speed = 15;
  hands.hand[0] = press_at(def, 0.0);
  const std::uint64_t seen = view.change();
  for (int n = 0; n < 400; ++n) {
    hands.hand[0].position.x -= 5e-6;
    hands.hand[0].position.y = 0.03;
    scene.step(hands, 1e-3);
  }
  send_all();
  int moved = 0, shaped = 0;
  for (int j = 0; j < view.rows(); ++j) {
    shaped += view.shaped_at(j) > seen ? 1 : 0;
    moved += view.placed_at(j) > seen && view.shaped_at(j) <= seen ? 1 : 0;
    EXPECT_EQ(view.row_height(j), scene.clay().row_height(j));
  }
  EXPECT_GT(view.rim_height(), before.rim_height());
  EXPECT_GT(moved, def.clay.rows / 2);
  EXPECT_GT(shaped, 2);
  EXPECT_LT(shaped, def.clay.rows / 2);
}

TEST(WheelView, PrintsOfBlowsComeWhenItIsSettledAndGoWithTheNextPot) {
  SteppedWheel wheel_host;
  SceneDef def = small_scene();
  def.clay.inner_radius = 0.03;
  def.volume.emplace();
  def.beating.emplace();
  def.prints.emplace();
  wheel_host.start(pot(def));
  wheel_host.hold(InHand::paddle);
  HandInput hand;
  hand.active = true;
  hand.position = {def.clay.outer_radius + def.tool.radius - 0.001, def.clay.height / 2, 0};
  wheel_host.hand(0, hand);
  wheel_host.advance(1500);
  wheel_host.collect();
  EXPECT_TRUE(wheel_host.view().prints.empty());
  ASSERT_TRUE(wheel_host.refresh_every_row());
  EXPECT_FALSE(wheel_host.view().prints.empty());
  wheel_host.start(pot(def));
  EXPECT_TRUE(wheel_host.view().prints.empty());
}

TEST(WheelView, APotThatRestsDoesNotSagAndNoHandIsAtIt) {
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.wheel(15);
  wheel_host.hand(0, press_at(def, 0.002));
  wheel_host.advance(100);
  wheel_host.collect();
  EXPECT_TRUE(wheel_host.view().status.hand[0].present);
  EXPECT_TRUE(wheel_host.view().status.feedback.hand[0].contact);
  wheel_host.pause(true);
  ASSERT_TRUE(wheel_host.refresh_every_row());
  std::uint64_t hash = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) { hash = scene.state_hash(); }));
  wheel_host.advance(1000);
  wheel_host.collect();
  EXPECT_FALSE(wheel_host.view().status.hand[0].present);
  EXPECT_FALSE(wheel_host.view().status.feedback.hand[0].contact);
  EXPECT_TRUE(wheel_host.view().status.hands.hand[0].active) << "but a hand that moves is noticed";
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) { EXPECT_EQ(scene.state_hash(), hash); }));
}

TEST(WheelView, APotThatTheWireCutFreeStandsWhileTheWheelTurnsOn) {
  SteppedWheel wheel_host;
  SceneDef def = small_scene();
  wheel_host.start(pot(def));
  const auto wire = static_cast<std::uint8_t>(
      std::ranges::find(def.tools, "wire", &SceneTool::name) - def.tools.begin() + 1);
  wheel_host.wheel(10);
  wheel_host.take(0, wire);
  HandInput hand;
  hand.active = true;
  for (int n = 0; n < 1000; ++n) {
    hand.position = {0.10 - 0.00025 * n, 0.004, 0};
    wheel_host.hand(0, hand);
    wheel_host.advance(2);
    wheel_host.collect();
    const ClayView& clay = wheel_host.view().clay;
    if (clay.cut_free < 1.0) {
      ASSERT_EQ(clay.angle, wheel_host.view().status.feedback.wheel_angle);
    }
  }
  EXPECT_EQ(wheel_host.view().clay.cut_free, 1.0);
  const double stands = wheel_host.view().clay.angle;
  wheel_host.advance(137);
  wheel_host.collect();
  EXPECT_EQ(wheel_host.view().clay.angle, stands);
  EXPECT_NE(wheel_host.view().status.feedback.wheel_angle, stands);
}

}  // namespace
}  // namespace onggi::loop::wheel_view_test
