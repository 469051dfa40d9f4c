#include "kiosk/wheel/loop/leather_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "kiosk/wheel/device/hid_hand.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"
#include "tests/stand_in/simulated_handle.h"
#include "tests/stand_in/world.h"

// A force device at a leather-hard pot.

namespace onggi::loop::leather_work_test {
namespace {

using force::DecoratingLaw;
using force::DecoratingTool;

constexpr DecoratingTool kNeedle{DecoratingLaw::cut, 1e-3, 6e-4, 0.0, 0.5};
constexpr DecoratingTool kLoop{DecoratingLaw::cut, 0.008, 7e-4};
constexpr DecoratingTool kBrush{DecoratingLaw::brush, 0.008, 0.002};
constexpr double kRadius = 0.06;

/// A cylinder, 150 mm high.
std::unique_ptr<force::LeatherOutline> cylinder() {
  return std::make_unique<force::LeatherOutline>(
      std::vector<Vec2>{{kRadius, 0.0}, {kRadius, 0.15}, {0.054, 0.15}, {0.054, 0.01}});
}

/// A hand without a spring, that notes what it feels.
class Bare final : public device::HandDevice {
 public:
  HandInput read(double) noexcept override { return at; }
  void feel(const HandFeedback& now) noexcept override { felt = now; }
  HandInput at;
  HandFeedback felt;
};

/// A wheel with a pot on it that was pressed a little, and a bare hand.
struct AtWheel {
  AtWheel() {
    auto owned = std::make_unique<Bare>();
    hand = owned.get();
    wheel.start(pot(small_scene()));
    wheel.attach(std::move(owned), 0);
    wheel.advance(5);
  }
  void go(double radius, int ticks = 1, double height = 0.08) {
    hand->at.active = true;
    for (int n = 0; n < ticks; ++n) {
      hand->at.position = {radius, height, 0.0};
      wheel.advance(1);
    }
  }
  std::uint64_t hash() {
    std::uint64_t found = 0;
    EXPECT_TRUE(wheel.with_scene([&](Scene& scene) { found = scene.state_hash(); }));
    return found;
  }
  SteppedWheel wheel;
  Bare* hand = nullptr;
};

TEST(LeatherWork, TheClayIsTheSameToTheBitAfterIt) {
  AtWheel at;
  at.wheel.wheel(10.0);
  at.wheel.advance(50);
  const std::uint64_t before = at.hash();
  const std::uint64_t ticks = at.wheel.status().ticks;
  at.wheel.harden(cylinder());
  at.wheel.decorate(kLoop, {});
  at.go(0.061, 400);
  at.go(0.0585, 400);
  EXPECT_TRUE(at.wheel.status().leather);
  EXPECT_TRUE(at.hand->felt.contact);
  EXPECT_EQ(at.wheel.status().ticks, ticks);
  EXPECT_EQ(at.hash(), before) << "also while it is lent";
  at.wheel.harden(nullptr);
  at.go(0.0585, 110);
  EXPECT_FALSE(at.wheel.status().leather);
  at.hand->at.active = false;
  EXPECT_NE(at.wheel.status().ticks, ticks) << "then the wheel goes on";
}

TEST(LeatherWork, APotThatRestsIsDecoratedAllTheSameAndRestsAgainAfterIt) {
  AtWheel at;
  at.wheel.pause(true);
  at.wheel.advance(1);
  const std::uint64_t before = at.hash();
  at.wheel.harden(cylinder());
  at.wheel.decorate(kLoop, {});
  at.go(0.061, 400);
  at.go(0.0585, 400);
  EXPECT_GT(length(at.hand->felt.force), 0.1);
  at.wheel.harden(nullptr);
  at.go(0.0585, 300);
  EXPECT_EQ(at.hash(), before);
  EXPECT_EQ(length(at.hand->felt.force), 0.0);
  EXPECT_FALSE(at.wheel.status().leather);
}

TEST(LeatherWork, PlaceDepthAndContactAreToldAsThePotStandsOnTheScreen) {
  AtWheel at;
  at.wheel.harden(cylinder());
  at.wheel.decorate(kNeedle, {0.5, 0.0});
  at.go(0.065, 400);
  EXPECT_TRUE(at.wheel.status().at_leather[0].near);
  EXPECT_FALSE(at.wheel.status().at_leather[0].contact);
  EXPECT_FALSE(at.wheel.status().at_leather[1].near);
  at.go(0.0597, 10, 0.07);
  const force::LeatherPlace place = at.wheel.status().at_leather[0];
  EXPECT_TRUE(place.contact);
  EXPECT_NEAR(place.depth, 3e-4, 1e-9);
  EXPECT_NEAR(place.along, 0.07, 1e-9);
  EXPECT_NEAR(place.turns, 1.0 - 0.5 / 6.283185307, 1e-6);
  EXPECT_FALSE(at.wheel.status().hand[0].present) << "no wheel's tool is drawn";
  // It turns on between frames, but not for ever where no frame comes.
  at.wheel.decorate(kNeedle, {0.5, 1.0});
  at.go(0.0597, 50, 0.07);
  EXPECT_NEAR(at.wheel.status().at_leather[0].turns, 1.0 - 0.55 / 6.283185307, 1e-4);
  at.go(0.0597, 1000, 0.07);
  EXPECT_NEAR(at.wheel.status().at_leather[0].turns, 1.0 - 0.60 / 6.283185307, 1e-3);
  at.hand->at.active = false;
  at.wheel.advance(1);
  EXPECT_FALSE(at.wheel.status().at_leather[0].near);
}

TEST(LeatherWork, ATouchComesAndGoesEvenlyAsToolsChangeAndAsItEnds) {
  AtWheel at;
  at.wheel.pause(true);  // After it the soft clay is not met.
  at.wheel.harden(cylinder());
  at.wheel.decorate(kLoop, {});
  at.go(0.061, 10);
  double before = 0.0, step = 0.0;
  const auto felt = [&](int ticks) {
    for (int n = 0; n < ticks; ++n) {
      at.go(0.0594);
      const double now = length(at.hand->felt.touch.push);
      step = std::max(step, std::fabs(now - before));
      before = now;
    }
    return before;
  };
  at.go(0.0594);
  before = length(at.hand->felt.touch.push);
  const double loop = felt(400);
  EXPECT_NEAR(loop, force::press_of(kLoop, 6e-4).push, 1e-9);
  at.wheel.decorate(kBrush, {});
  EXPECT_NEAR(felt(600), force::press_of(kBrush, 6e-4).push, 1e-9);
  at.wheel.decorate({}, {});
  EXPECT_EQ(felt(600), 0.0);
  at.wheel.decorate(kLoop, {});
  EXPECT_NEAR(felt(600), loop, 1e-9);
  at.wheel.harden(nullptr);
  felt(120);
  EXPECT_FALSE(at.wheel.status().leather);
  EXPECT_LE(step, 0.0101 * loop) << "a hundredth a tick: 0.1 s";
}

TEST(LeatherWork, AHandThatAFingerOrAKeyLeadsDoesNotTouchIt) {
  SteppedWheel wheel;
  wheel.start(pot(small_scene()));
  wheel.harden(cylinder());
  wheel.decorate(kLoop, {});
  HandInput hand;
  hand.active = true;
  hand.position = {0.061, 0.08, 0.0};
  wheel.hand(0, hand);
  wheel.advance(600);
  EXPECT_FALSE(wheel.status().at_leather[0].near);
}

TEST(LeatherWork, ANewPotAScriptAndTheEndOfItGiveTheWallBack) {
  AtWheel at;
  for (const int how : {0, 1, 2}) {
    at.wheel.harden(cylinder());
    at.wheel.decorate(kLoop, {});
    at.go(0.061, 5);
    ASSERT_TRUE(at.wheel.status().leather);
    if (how == 0) at.wheel.start(pot(small_scene()));
    if (how == 1)
      at.wheel.play(std::move(*make_script("groove", {small_scene(), nullptr, 1, 1.0})));
    if (how == 2) at.wheel.harden(nullptr);
    at.go(0.061, how == 2 ? 150 : 2);
    EXPECT_FALSE(at.wheel.status().leather) << how;
    at.wheel.collect();
    at.wheel.play(nullptr);
  }
  // Leaks show under the sanitizer: one is worked, one waits in the queue as the wheel ends.
  at.wheel.harden(cylinder());
  at.wheel.advance(1);
  at.wheel.harden(cylinder());
}

/// A reference device in a simulated hand that leads it into the wall and up it.
struct Reference {
  explicit Reference(double deep = 0.002)
      : home(device::default_def(device::DeviceKind::onggi_hid).home) {
    const Vec3 out = (1.0 / axis_distance(home)) * Vec3{home.x, 0.0, home.z};
    std::vector<stand_in::TrackPoint> points;
    // From 2 mm off the wall into it by `deep`, then 30 mm up, then away.
    for (int n = 0; n < 3000; ++n) {
      const double in = std::clamp((n - 800) / 600.0, 0.0, 1.0);
      const double up = std::clamp((n - 1500) / 1000.0, 0.0, 1.0);
      points.push_back({home - (0.002 + deep) * in * out + Vec3{0.0, 0.03 * up, 0.0}, true});
    }
    auto owned = std::make_unique<stand_in::SimulatedHandle>(stand_in::Track(points));
    handle = owned.get();
    world.plug(std::move(owned));
    const auto listed = world.list();
    auto bus = stand_in::bus_of(world);
    const auto kind = device::DeviceKind::onggi_hid;
    device::DeviceDef def = device::default_def(kind);
    def.stiffness_limit = 257.0;
    link = device::HidLink::begin({bus->open(listed[0].path), kind, listed[0], def},
                                  device::HidLink::Turning::by_hand);
    wheel.start(pot(small_scene()));
    wheel.attach(std::make_unique<device::HidHand>(link), 0);
  }
  /// The wall, 2 mm before the handle at home.
  std::unique_ptr<force::LeatherOutline> wall() const {
    const double radius = axis_distance(home) - 0.002;
    return std::make_unique<force::LeatherOutline>(std::vector<Vec2>{{radius, 0.0}, {radius, 0.4}});
  }
  void tick(bool beats = true) {
    if (beats) link->heartbeat();
    wheel.advance(1);
  }
  Vec3 home;
  stand_in::World world;
  stand_in::SimulatedHandle* handle = nullptr;
  std::shared_ptr<device::HidLink> link;
  SteppedWheel wheel;
};

/// Greatest force against the way up, and the greatest step of the force, while a tool is led.
std::pair<double, double> led(const DecoratingTool& tool, double deep = 0.002) {
  Reference at(deep);
  at.wheel.harden(at.wall());
  at.wheel.decorate(tool, {});
  double against = 0.0, step = 0.0;
  Vec3 was;
  bool touched = false;
  for (int n = 0; n < 2500; ++n) {
    at.tick();
    at.wheel.decorate(tool, {});
    const Vec3 force = at.handle->force();
    step = std::max(step, length(force - was));
    was = force;
    touched = touched || at.wheel.status().at_leather[0].contact;
    if (n > 2000) against = std::max(against, -force.y);
  }
  EXPECT_EQ(touched, tool.law != DecoratingLaw::none);
  return {against, step};
}

// The table of engine/docs/force.md is what this prints.
TEST(LeatherWork, TheReferenceDeviceFeelsEveryToolInItsRange) {
  struct Row {
    const char* name;
    DecoratingTool tool;
    double least, most;  // N
  };
  const Row rows[] = {
      {"needle, a V of 1.0 mm, 0.6 deep", kNeedle, 0.1, 0.6},
      {"the same, dry", {DecoratingLaw::cut, 1e-3, 6e-4, 1.0, 0.5}, 0.1, 0.6},
      {"comb, 5 teeth of 0.8 mm, 0.6 deep", {DecoratingLaw::cut, 0.004, 6e-4, 0.0, 0.5}, 0.4, 2.0},
      {"loop of 8 mm, 0.7 deep", kLoop, 2.0, 8.0},
      {"scraper of 20 mm, 0.15 deep", {DecoratingLaw::scrape, 0.02, 1.5e-4}, 2.0, 8.0},
      {"brush of 8 mm", kBrush, 0.02, 0.3},
      {"wiping finger of 12 mm", {DecoratingLaw::wipe, 0.012, 0.0015}, 0.05, 1.5},
      {"stamp of 8 mm", {DecoratingLaw::stamp, 0.008, 6e-4}, 0.05, 2.0}};
  for (const Row& row : rows) {
    const auto [against, step] = led(row.tool, row.tool == kLoop ? 0.004 : 0.002);
    std::printf("%s: %.2f N, steps of %.3f N\n", row.name, against, step);
    EXPECT_GE(against, row.least) << row.name;
    EXPECT_LE(against, row.most) << row.name;
    EXPECT_LT(step, 0.05) << row.name;
  }
  EXPECT_EQ(led({}).first, 0.0);
}

TEST(LeatherWork, WhereTheProgramFallsSilentTheDevicesForceEnds) {
  Reference at;
  at.wheel.harden(at.wall());
  at.wheel.decorate(kNeedle, {});
  for (int n = 0; n < 1800; ++n) at.tick();
  ASSERT_GT(length(at.handle->force()), 0.1);
  for (int n = 0; n < 700; ++n) at.tick(false);
  EXPECT_EQ(length(at.handle->force()), 0.0);
}

TEST(LeatherWork, WhileTicksComeLateItsForceFadesAsAtTheWheel) {
  WheelLoop core;
  auto owned = std::make_unique<Bare>();
  core.send(command::Attach{owned.get(), 0});
  core.send(command::Harden{cylinder().release()});
  core.send(command::Decorate{kLoop, {}});
  owned->at.active = true;
  owned->at.position = {0.061, 0.08, 0.0};
  for (int n = 0; n < 600; ++n) core.tick(1e-3);
  owned->at.position.x = 0.0594;
  for (int n = 0; n < 600; ++n) core.tick(1e-3);
  ASSERT_GT(length(owned->felt.touch.push), 0.1);
  core.strained(true);
  for (int n = 0; n < 60; ++n) core.tick(1e-3);
  EXPECT_EQ(length(owned->felt.touch.push), 0.0);
  EXPECT_EQ(owned->felt.touch.grip, 0.0);
}

}  // namespace
}  // namespace onggi::loop::leather_work_test
