#include "kiosk/visit/screens/show_me.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/replay.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::show_me_test {
namespace {

double off(const ClayView& clay, const Profile& target) {
  double squares = 0;
  for (double h = 0.03; h < 0.19; h += 0.002)
    squares += std::pow(clay.radius_at(h, WallSide::outside) - target.outer_at(h), 2);
  return std::sqrt(squares);
}

double off(const ClayView& clay, const ClayView& other) {
  double most = 0;
  for (double h = 0.03; h < 0.19; h += 0.002)
    most = std::max(most, std::abs(clay.radius_at(h, WallSide::outside) -
                                   other.radius_at(h, WallSide::outside)));
  return most;
}

// Real clay on a wheel that is stepped.
struct RealWheel {
  RealWheel() {
    SceneDef def;
    def.clay.rows = 120;
    def.clay.sectors = 24;
    wheel_host.start(std::make_unique<Scene>(std::move(*Scene::create(def))));
    wheel_host.record("jar", 1);
    wheel_host.wheel(25);
    world.wheel = &wheel_host.view();
    world.wheel_commands = &wheel_host;
    frames(60);
  }
  void frames(int count) {
    for (int n = 0; n < count; ++n) {
      wheel_host.advance(20);
      wheel_host.collect();
      show.draw(0.02, hands, wheel_host.view().clay);
      bool contact = false;
      for (const HandFeedback& f : wheel_host.view().status.feedback.hand) contact |= f.contact;
      hands.follow(wheel_host.view().clay, 0.02, contact);
      const auto both = hands.input({1, 0, 0});
      for (int h = 0; h < kMaxHands; ++h) wheel_host.hand(h, both[static_cast<std::size_t>(h)]);
    }
  }
  // A stroke from a press of the button to the hands being off again.
  void stroke(const Profile& target) {
    Desk desk(world);
    show.press(desk, target, 1, hands);
    for (int n = 0; n < 1500 && (show.showing() || hands.active()); ++n) frames(1);
    EXPECT_FALSE(show.showing());
    frames(60);
  }
  loop::SteppedWheel wheel_host;
  VisitInputs world;
  device::PointerLead hands{{6, 0.018}, {0, 0.008}};
  ShowMe show;
};

TEST(ShowMe, StrokesBringAPotNearerAndAreRecordedLikeAnyHandsAndTakenBackOneByOne) {
  RealWheel wheel;
  const Profile target = jar(0.075, 0.05, 0.05);
  const double lump = off(wheel.wheel_host.view().clay, target);
  wheel.stroke(target);
  ASSERT_TRUE(wheel.wheel_host.refresh_every_row());
  EXPECT_GT(wheel.wheel_host.view().clay.radius_at(0.1, WallSide::inside), 0.025)
      << "a thick wall is opened first";
  ClayView before;
  for (int n = 0; n < 5; ++n) {
    ASSERT_TRUE(wheel.wheel_host.refresh_every_row());
    before = wheel.wheel_host.view().clay;
    wheel.stroke(target);
  }
  ASSERT_TRUE(wheel.wheel_host.refresh_every_row());
  EXPECT_LT(off(wheel.wheel_host.view().clay, target), 0.5 * lump);

  std::uint64_t hash = 0;
  ASSERT_TRUE(wheel.wheel_host.with_scene([&](Scene& scene) { hash = scene.state_hash(); }));
  const auto replay = Replay::read(wheel.wheel_host.replay(hash), "test");
  ASSERT_TRUE(replay.has_value());
  const auto outcome = run_replay(*replay);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->replayed_hash, hash);

  // A touch of more than three seconds is taken back in steps of three (engine/clay/history.h).
  double apart = 1;
  for (int step = 0; step < 8 && apart > 1e-6; ++step) {
    ASSERT_TRUE(wheel.wheel_host.view().status.can_restore);
    wheel.wheel_host.restore();
    wheel.frames(60);
    ASSERT_TRUE(wheel.wheel_host.refresh_every_row());
    apart = off(wheel.wheel_host.view().clay, before);
  }
  EXPECT_LE(apart, 1e-6);
}

TEST(ShowMe, ItGoesOnUntilItIsPressedAgain) {
  Visitor v;
  v.throw_a_pot();
  v.touch("throw.show");
  v.frames(1.5);
  EXPECT_NE(words_in(v.frame).find("Watch:"), std::string::npos);
  ASSERT_GE(v.wheel_commands.hands.size(), 2u);
  EXPECT_TRUE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active);
  v.touch("throw.show");
  v.frames(0.1);
  EXPECT_EQ(words_in(v.frame).find("Watch:"), std::string::npos);
  EXPECT_FALSE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active);
}

TEST(ShowMe, HeldItEndsWhereItIsLetGo) {
  Visitor v;
  v.throw_a_pot();
  const auto button = v.visit->control("throw.show");
  ASSERT_TRUE(button);
  v.down(button->x + 5, button->y + 5);
  v.frames(2);
  EXPECT_NE(words_in(v.frame).find("Watch:"), std::string::npos);
  v.up(button->x + 5, button->y + 5);
  v.show();
  EXPECT_EQ(words_in(v.frame).find("Watch:"), std::string::npos);
}

TEST(ShowMe, WhoTouchesThePotTakesOverAtOnceAndAMouseThatOnlyPassesDoesNot) {
  Visitor v;
  v.throw_a_pot();
  v.touch("throw.show");
  v.frames(1);
  v.move(900, 200);
  v.frames(0.2);
  EXPECT_NE(words_in(v.frame).find("Watch:"), std::string::npos);
  v.down(900, 300);
  v.frames(0.2);
  EXPECT_EQ(words_in(v.frame).find("Watch:"), std::string::npos);
  EXPECT_TRUE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active)
      << "the visitor's own";
  v.up(900, 300);
}

TEST(ShowMe, ByKeysItBeginsAndAnArrowTakesOver) {
  Visitor v;
  v.throw_a_pot();
  v.key(view::Key::enter);
  ASSERT_TRUE(v.key_to("throw.show"));
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("Watch:"), std::string::npos);
  v.key(view::Key::back);
  v.key(view::Key::up);
  v.frames(0.2);
  EXPECT_EQ(words_in(v.frame).find("Watch:"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::show_me_test
