#include "kiosk/wheel/loop/wheel_view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"

namespace onggi::loop {
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
  SteppedWheel potter;
  const SceneDef def = small_scene();
  potter.start(pot(def));
  potter.wheel(15);
  potter.hand(0, press_at(def, 0.004));
  potter.advance(800);
  potter.hand(0, HandInput{});
  for (int i = 0; i < 30; ++i) {  // It comes off slowly.
    potter.advance(20);
    potter.collect();
  }
  EXPECT_LT(potter.view().clay.radius_at(def.clay.height / 2, WallSide::outside),
            def.clay.outer_radius - 0.002);
  expect_the_view_is_the_clay(potter);
}

TEST(WheelView, ARimThatIsPressedDownReachesTheView) {
  SteppedWheel potter;
  SceneDef def = small_scene();
  def.clay.inner_radius = 0.049;
  potter.start(pot(def));
  potter.wheel(15);
  HandInput hand;
  hand.active = true;
  for (int n = 0; n < 60; ++n) {
    hand.position = {0.052, def.clay.height + def.tool.radius + 0.002 - n * 0.0001, 0};
    potter.hand(0, hand);
    potter.advance(20);
    potter.collect();
  }
  potter.hand(0, HandInput{});
  for (int i = 0; i < 30; ++i) {  // It comes off slowly.
    potter.advance(20);
    potter.collect();
  }
  EXPECT_LT(potter.view().clay.rim_height(), def.clay.height - 0.001);
  expect_the_view_is_the_clay(potter);
  ASSERT_TRUE(potter.with_scene([&](Scene& scene) {
    const Profile shown = potter.view().clay.profile();
    const Profile real = scene.clay().profile();
    ASSERT_EQ(shown.points.size(), real.points.size());
    for (std::size_t n = 0; n < real.points.size(); ++n) {
      EXPECT_EQ(shown.points[n].height, real.points[n].height);
      EXPECT_EQ(shown.points[n].outer, real.points[n].outer);
    }
  }));
}

/// A pot on which a rim press is under way, seen as it was some ticks ago.
void press_rim(SteppedWheel& potter, SceneDef& def) {
  def.clay.inner_radius = 0.049;
  potter.start(pot(def));
  potter.wheel(15);
  for (int n = 0; n < 60; ++n) {
    HandInput hand;
    hand.active = true;
    hand.position = {0.052, def.clay.height + def.tool.radius + 0.002 - n * 0.0001, 0};
    potter.hand(0, hand);
    potter.advance(20);
    if (n < 50) potter.collect();
  }
}

TEST(WheelView, ASettledViewIsTheClayToTheBitThoughRowsWereOnTheirWay) {
  SteppedWheel potter;
  SceneDef def = small_scene();
  press_rim(potter, def);
  const double before = potter.view().clay.rim_height();
  ASSERT_TRUE(potter.refresh_every_row());
  EXPECT_LT(potter.view().clay.rim_height(), before) << "some were";
  expect_the_view_is_the_clay(potter);
  ASSERT_TRUE(potter.with_scene([&](Scene& scene) {
    const Profile seen = potter.view().clay.profile(), real = scene.clay().profile();
    ASSERT_EQ(seen.points.size(), real.points.size());
    for (std::size_t n = 0; n < real.points.size(); ++n) {
      EXPECT_EQ(seen.points[n].height, real.points[n].height);
      EXPECT_EQ(seen.points[n].outer, real.points[n].outer);
      EXPECT_EQ(seen.points[n].inner, real.points[n].inner);
    }
  }));
  // What was on its way when it was settled does not come after it.
  potter.advance(1);
  potter.hand(0, HandInput{});
  for (int i = 0; i < 30; ++i) {  // It comes off slowly.
    potter.advance(20);
    potter.collect();
  }
  expect_the_view_is_the_clay(potter);
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

TEST(WheelView, APotThatRestsDoesNotSagAndNoHandIsAtIt) {
  SteppedWheel potter;
  const SceneDef def = small_scene();
  potter.start(pot(def));
  potter.wheel(15);
  potter.hand(0, press_at(def, 0.002));
  potter.advance(100);
  potter.collect();
  EXPECT_TRUE(potter.view().status.hand[0].present);
  EXPECT_TRUE(potter.view().status.feedback.hand[0].contact);
  potter.pause(true);
  ASSERT_TRUE(potter.refresh_every_row());
  std::uint64_t hash = 0;
  ASSERT_TRUE(potter.with_scene([&](Scene& scene) { hash = scene.state_hash(); }));
  potter.advance(1000);
  potter.collect();
  EXPECT_FALSE(potter.view().status.hand[0].present);
  EXPECT_FALSE(potter.view().status.feedback.hand[0].contact);
  EXPECT_TRUE(potter.view().status.hands.hand[0].active) << "but a hand that moves is noticed";
  ASSERT_TRUE(potter.with_scene([&](Scene& scene) { EXPECT_EQ(scene.state_hash(), hash); }));
}

TEST(WheelView, APotThatTheWireCutFreeStandsWhileTheWheelTurnsOn) {
  SteppedWheel potter;
  SceneDef def = small_scene();
  potter.start(pot(def));
  const auto wire = static_cast<std::uint8_t>(
      std::ranges::find(def.tools, "wire", &SceneTool::name) - def.tools.begin() + 1);
  potter.wheel(10);
  potter.take(0, wire);
  HandInput hand;
  hand.active = true;
  for (int n = 0; n < 1000; ++n) {
    hand.position = {0.10 - 0.00025 * n, 0.004, 0};
    potter.hand(0, hand);
    potter.advance(2);
    potter.collect();
    const ClayView& clay = potter.view().clay;
    if (clay.cut_free < 1.0) {
      ASSERT_EQ(clay.angle, potter.view().status.feedback.wheel_angle);
    }
  }
  EXPECT_EQ(potter.view().clay.cut_free, 1.0);
  const double stands = potter.view().clay.angle;
  potter.advance(137);
  potter.collect();
  EXPECT_EQ(potter.view().clay.angle, stands);
  EXPECT_NE(potter.view().status.feedback.wheel_angle, stands);
}

}  // namespace
}  // namespace onggi::loop
