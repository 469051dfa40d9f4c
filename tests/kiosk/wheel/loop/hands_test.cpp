#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

#include "engine/scene/replay.h"
#include "kiosk/wheel/loop/fault_log.h"
#include "kiosk/wheel/loop/loop_thread.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"

// Hands are devices: several, of any kind, with any tool.

namespace onggi::loop::hands_test {
namespace {

/// A hand that is somewhere, and tells what it felt, and when it went.
struct Notes {
  HandInput hand;
  std::vector<HandFeedback> felt;
  bool gone = false;
};
class NotedHand final : public device::HandDevice {
 public:
  explicit NotedHand(Notes& notes) : notes_(notes) { notes_.felt.reserve(100000); }
  ~NotedHand() override { notes_.gone = true; }
  HandInput read(double) noexcept override { return notes_.hand; }
  void feel(const HandFeedback& felt) noexcept override { notes_.felt.push_back(felt); }

 private:
  Notes& notes_;
};

/// The hand comes to the wall from outside at 5 mm/s, for `ticks`.
void come(SteppedWheel& wheel_host, Notes& notes, const SceneDef& def, int ticks, double y) {
  notes.hand = press_at(def, -0.0002);
  notes.hand.position.y = y;
  for (int n = 0; n < ticks; ++n) {
    notes.hand.position.x -= 5e-6;
    wheel_host.advance(1);
  }
}

std::uint8_t tool_of(const SceneDef& def, std::string_view name) {
  return static_cast<std::uint8_t>(std::ranges::find(def.tools, name, &SceneTool::name) -
                                   def.tools.begin() + 1);
}

TEST(HandDevices, WhileTicksComeTooLateForcesGoDownAndThenComeBackSlowly) {
  class Pushed final : public device::HandDevice {
   public:
    explicit Pushed(double& felt) : felt_(felt) {}
    HandInput read(double) noexcept override { return at; }
    void feel(const HandFeedback& felt) noexcept override { felt_ = length(felt.force); }
    HandInput at;

   private:
    double& felt_;
  };
  double felt = 0.0;
  WheelLoop core;
  SceneDef def = small_scene();
  def.guard.engage_time = 0.05;
  def.contact.relaxation_time = 1.0;
  auto owned = std::make_unique<Pushed>(felt);
  core.send(command::Attach{owned.get(), 0});
  core.send(command::Put{new Pot(std::move(*pot(def)), 1)});
  for (int ms = 0; ms < 100; ++ms) {
    owned->at = press_at(def, -0.0002);
    core.tick(1e-3);
  }
  for (int ms = 0; ms < 200; ++ms) {
    owned->at = press_at(def, 1e-5 * ms);
    core.tick(1e-3);
  }
  const double before = felt;
  ASSERT_GT(before, 0.05);
  core.strained(true);
  for (int ms = 0; ms < 60; ++ms) {
    const double last = felt;
    core.tick(1e-3);
    EXPECT_LE(felt, last + 1e-12);
  }
  EXPECT_EQ(felt, 0.0);
  core.strained(false);
  core.tick(1e-3);
  EXPECT_LT(felt, 0.05 * before);
  for (int ms = 0; ms < 600; ++ms) core.tick(1e-3);
  EXPECT_GT(felt, 0.0);
}

TEST(HandDevices, WhateverADeviceReportsReachesTheScene) {
  Notes notes;
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  notes.hand = {{-0.09, 0.07, 0.01}, true, SideWish::outside, tool_of(def, "flat_rib"),
                {0.1, 1.0, 0.2},     0.3};
  ASSERT_NE(wheel_host.attach(std::make_unique<NotedHand>(notes), 1), nullptr);
  wheel_host.advance(1);
  wheel_host.collect();
  EXPECT_EQ(wheel_host.view().status.hands.hand[1], notes.hand);
  const HandView& seen = wheel_host.view().status.hand[1];
  EXPECT_TRUE(seen.present);
  EXPECT_EQ(seen.name, "flat_rib");
  EXPECT_EQ(seen.body, BodyKind::box);
  EXPECT_EQ(seen.at, notes.hand.position);
  EXPECT_NEAR(length(cross(seen.along, notes.hand.handle)), 0.0, 1e-12);
  EXPECT_NEAR(dot(seen.along, seen.across), 0.0, 1e-12);
  EXPECT_FALSE(wheel_host.view().status.hand[0].present);
}

TEST(HandDevices, OfSeveralForOneHandTheLastThatIsInUseLeadsAndItAloneFeelsTheClay) {
  Notes first, last;
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.attach(std::make_unique<NotedHand>(first), 0);
  wheel_host.attach(std::make_unique<NotedHand>(last), 0);
  come(wheel_host, first, def, 700, 0.1);
  EXPECT_GT(length(first.felt.back().force), 0.0);
  EXPECT_EQ(length(last.felt.back().force), 0.0);
  come(wheel_host, last, def, 700, 0.05);
  EXPECT_EQ(wheel_host.status().hands.hand[0], last.hand);
  EXPECT_EQ(length(first.felt.back().force), 0.0);
  EXPECT_GT(length(last.felt.back().force), 0.0);
  last.hand.active = false;
  wheel_host.advance(1);
  EXPECT_EQ(wheel_host.status().hands.hand[0], first.hand);
}

TEST(HandDevices, ADeviceThatLeavesFeelsNothingMoreAndIsDestroyedOnceTheLoopHasLetGo) {
  Notes notes;
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  device::HandDevice* const name = wheel_host.attach(std::make_unique<NotedHand>(notes), 0);
  come(wheel_host, notes, def, 700, 0.1);
  EXPECT_GT(length(notes.felt.back().force), 0.0);
  wheel_host.detach(name);
  wheel_host.collect();
  EXPECT_FALSE(notes.gone) << "the loop still has it";
  wheel_host.advance(1);
  EXPECT_EQ(length(notes.felt.back().force), 0.0);
  EXPECT_FALSE(wheel_host.status().hand[0].present);
  wheel_host.collect();
  EXPECT_TRUE(notes.gone);
}

TEST(HandDevices, OneTooManyIsTurnedAway) {
  std::vector<Notes> notes(WheelLoop::kMostDevices);
  Notes third_hand;
  SteppedWheel wheel_host;
  for (Notes& each : notes) wheel_host.attach(std::make_unique<NotedHand>(each), 0);
  wheel_host.attach(std::make_unique<NotedHand>(third_hand), 2);
  wheel_host.advance(1);
  wheel_host.collect();
  // The pointers of both hands were there before.
  for (std::size_t n = 0; n < notes.size(); ++n)
    EXPECT_EQ(notes[n].gone, n >= notes.size() - kMaxHands) << n;
  EXPECT_TRUE(third_hand.gone);
}

/// A hand that counts how often the loop asked where it is.
class CountedHand final : public device::HandDevice {
 public:
  CountedHand(std::atomic<int>& reads, bool& gone) : reads_(reads), gone_(gone) {}
  ~CountedHand() override { gone_ = true; }
  HandInput read(double) noexcept override { return ++reads_, HandInput{}; }
  void feel(const HandFeedback&) noexcept override {}

 private:
  std::atomic<int>& reads_;
  bool& gone_;
};

TEST(HandDevices, OneMayComeAndGoWhileTheLoopRuns) {
  std::atomic<int> reads{0};
  bool gone = false;
  LoopThread wheel_host;
  wheel_host.start(pot(small_scene()));
  for (int round = 0; round < 3; ++round) {
    gone = false;
    device::HandDevice* const name =
        wheel_host.attach(std::make_unique<CountedHand>(reads, gone), round % kMaxHands);
    const int before = reads;
    while (reads < before + 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    wheel_host.detach(name);
    for (int n = 0; n < 2000 && !gone; ++n) {
      wheel_host.collect();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(gone);
  }
}

TEST(HandDevices, AForceStopsWhereThePotRestsAndWhereAScriptMovesTheHands) {
  Notes notes;
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.attach(std::make_unique<NotedHand>(notes), 0);
  come(wheel_host, notes, def, 700, 0.1);
  ASSERT_GT(length(notes.felt.back().force), 0.0);
  wheel_host.pause(true);
  wheel_host.advance(1);
  EXPECT_EQ(length(notes.felt.back().force), 0.0);
  wheel_host.pause(false);
  come(wheel_host, notes, def, 700, 0.05);
  ASSERT_GT(length(notes.felt.back().force), 0.0);
  auto script = make_script("groove", {def, nullptr, 1, 1.0});
  ASSERT_TRUE(script);
  wheel_host.play(std::move(*script));
  for (int n = 0; n < 3000; ++n) {
    wheel_host.advance(1);
    ASSERT_EQ(length(notes.felt.back().force), 0.0);
  }
}

TEST(HandDevices, AToolThatIsTakenIsHeldUntilAnotherOneIsOrThePotIsNew) {
  SteppedWheel wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.hand(1, press_at(def, -0.02));
  wheel_host.advance(1);
  EXPECT_EQ(wheel_host.status().hand[1].name, "sphere");
  for (std::size_t k = 0; k < def.tools.size(); ++k) {
    wheel_host.take(1, static_cast<std::uint8_t>(k + 1));
    wheel_host.advance(2);
    EXPECT_EQ(wheel_host.status().hand[1].name, def.tools[k].name);
  }
  wheel_host.start(pot(def));
  wheel_host.hand(1, press_at(def, -0.02));
  wheel_host.advance(1);
  EXPECT_EQ(wheel_host.status().hand[1].name, "sphere");
}

TEST(HandDevices, AVisitWithEveryToolInTwoHandsIsTheOneItsReplayThrows) {
  Notes notes;  // of a device that knows its handle
  SteppedWheel wheel_host;
  SceneDef def = small_scene();
  def.volume.emplace();
  def.walls.emplace();
  def.smoothing.emplace();
  wheel_host.start(pot(def));
  wheel_host.record("test", 7);
  wheel_host.wheel(12);
  wheel_host.attach(std::make_unique<NotedHand>(notes), 1);
  const std::size_t tools = def.tools.size() + 1;
  std::vector<bool> touched(tools);
  for (std::size_t k = 0; k < tools; ++k) {
    const std::size_t other = (k + 3) % tools;
    wheel_host.take(0, static_cast<std::uint8_t>(k));
    wheel_host.take(1, static_cast<std::uint8_t>(other));
    for (int n = 0; n < 150; ++n) {
      HandInput hand = press_at(def, 0.0);
      hand.position = {0.13 - 0.0006 * n, 0.11, 0.01};
      wheel_host.hand(0, hand);
      const double a = 0.02 * n;
      notes.hand = {{-0.12 + 0.0006 * n, 0.05, 0},   n > 10, SideWish::outside, 0,
                    {std::sin(a), 1.0, std::cos(a)}, a};
      wheel_host.advance(4);
      wheel_host.collect();
      const LoopStatus& status = wheel_host.view().status;
      touched[k] = touched[k] || status.feedback.hand[0].contact;
      touched[other] = touched[other] || status.feedback.hand[1].contact;
    }
    wheel_host.hand(0, HandInput{});
    notes.hand = {};
    wheel_host.advance(4);
  }
  for (std::size_t k = 0; k < tools; ++k) EXPECT_TRUE(touched[k]) << k;
  EXPECT_GT(wheel_host.view().clay.cut_free, 0.0) << "the wire cut";
  EXPECT_EQ(wheel_host.view().status.feedback.faults, 0u);
  std::uint64_t hash = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) { hash = scene.state_hash(); }));
  const auto replay = Replay::read(wheel_host.replay(hash), "test");
  ASSERT_TRUE(replay.has_value());
  const auto outcome = run_replay(*replay);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->replayed_hash, hash);
}

/// A wheel whose ticks may last what they like.
class WildPotter final : public WheelHost {
 public:
  LoopStatus status() const override { return core_.status(); }
  void tick(double dt) { core_.tick(dt); }

 private:
  void let_loop_turn() override { core_.take_commands(); }
};

TEST(Faults, EachIsToldInTheLogOncePerPotAndComesAgainOnlyOnceItWasForgotten) {
  WildPotter wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  FaultLog log;
  const auto look = [&](double dt = 1e-3) {
    wheel_host.tick(dt);
    wheel_host.collect();
    return log.news(wheel_host.view().status);
  };
  EXPECT_TRUE(look().empty());
  HandInput lost = press_at(def, 0.0);
  lost.position.x = std::numeric_limits<double>::quiet_NaN();
  wheel_host.hand(0, lost);
  const auto hand = look();
  ASSERT_EQ(hand.size(), 1u);
  EXPECT_NE(hand[0].find("impossible position"), std::string::npos);
  EXPECT_EQ(wheel_host.view().status.feedback.faults, std::uint32_t{kFaultInput});
  const auto time = look(0.02);
  ASSERT_EQ(time.size(), 1u) << "the hand is known already";
  EXPECT_NE(time[0].find("5 ms"), std::string::npos);
  wheel_host.hand(0, HandInput{});
  wheel_host.clear_faults(kFaultInput);
  EXPECT_TRUE(look().empty());
  EXPECT_EQ(wheel_host.view().status.feedback.faults, std::uint32_t{kFaultTime});
  wheel_host.clear_faults(kFaultTime);
  EXPECT_TRUE(look().empty());
  EXPECT_EQ(wheel_host.view().status.feedback.faults, 0u);
  EXPECT_TRUE(look(0.02).empty()) << "a kind that the log has of this pot";
  EXPECT_EQ(wheel_host.view().status.feedback.faults, std::uint32_t{kFaultTime});
  wheel_host.start(pot(def));
  look();
  EXPECT_EQ(look(0.02).size(), 1u) << "another pot";
}

// The printed model divides nothing by nothing where a hand is on the axis (engine/docs/paper.md).
TEST(Faults, AForceThatIsNoNumberIsToldAndForgottenLikeTheOthers) {
  WildPotter wheel_host;
  SceneDef def = small_scene();
  def.clay = {.rows = 80,
              .sectors = 64,
              .height = 0.072,
              .inner_radius = 0.0001,
              .floor_thickness = 0.0,
              .wall_min = 0.0005,
              .radius_min = 0.0001};
  def.moisture.reset();
  def.friction.reset();
  def.paper.emplace();
  wheel_host.start(pot(def));
  FaultLog log;
  HandInput hand;
  hand.active = true;
  hand.position = {0.0, 0.036, 0.0};
  wheel_host.hand(0, hand);
  wheel_host.tick(1e-3);
  wheel_host.collect();
  EXPECT_NE(wheel_host.view().status.feedback.faults & kFaultForce, 0u);
  const auto force = log.news(wheel_host.view().status);
  ASSERT_EQ(force.size(), 1u);
  EXPECT_NE(force[0].find("not a number"), std::string::npos);
  EXPECT_TRUE(log.news(wheel_host.view().status).empty());
  wheel_host.hand(0, HandInput{});
  for (int n = 0; n < 400; ++n) wheel_host.tick(1e-3);  // It comes off slowly.
  wheel_host.clear_faults(kFaultForce);
  wheel_host.tick(1e-3);
  wheel_host.collect();
  EXPECT_EQ(wheel_host.view().status.feedback.faults, 0u);
}

TEST(Faults, WhatWasForgottenAtTheWheelIsNoDifferenceToTheReplay) {
  WildPotter wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.record("test", 1);
  HandInput lost = press_at(def, 0.001);
  for (int n = 0; n < 100; ++n) {
    lost.position.y = n == 50 ? std::numeric_limits<double>::infinity() : 0.1;
    wheel_host.hand(0, lost);
    wheel_host.tick(1e-3);
    wheel_host.collect();
  }
  EXPECT_NE(wheel_host.view().status.feedback.faults, 0u);
  wheel_host.clear_faults(~0u);
  wheel_host.tick(1e-3);
  wheel_host.collect();
  std::uint64_t hash = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) { hash = scene.state_hash(); }));
  const auto replay = Replay::read(wheel_host.replay(hash), "test");
  ASSERT_TRUE(replay.has_value());
  EXPECT_EQ(run_replay(*replay)->replayed_hash, hash);
}

}  // namespace
}  // namespace onggi::loop::hands_test
