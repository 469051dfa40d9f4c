#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include "engine/scene/replay.h"
#include "kiosk/wheel/loop/loop_thread.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"

namespace onggi::loop::wheel_commands_test {
namespace {

/// A stepped wheel with a pot on it.
struct Stepped {
  explicit Stepped(const SceneDef& def) {
    host.start(pot(def));
    host.advance(1);
    host.collect();
  }
  SteppedWheel host;
};

/// A device that somebody holds.
class HeldHand final : public device::HandDevice {
 public:
  /// At `hand`; what it feels of the clay goes to `contact`.
  explicit HeldHand(const bool& held, const HandInput& hand = away(), bool* contact = nullptr)
      : held_(held), hand_(hand), contact_(contact) {}
  static HandInput away() {
    HandInput hand;
    hand.position = {0.2, 0.2, 0.0};
    return hand;
  }
  HandInput read(double) noexcept override {
    hand_.active = held_;
    return hand_;
  }
  void feel(const HandFeedback& felt) noexcept override {
    if (contact_ != nullptr) *contact_ = felt.contact;
  }

 private:
  const bool& held_;
  HandInput hand_;
  bool* contact_;
};

TEST(Potter, AHandThatTheScreensLeadIsNoVisitorAndOneThatHoldsADeviceIs) {
  const SceneDef def = small_scene();
  Stepped wheel(def);
  wheel.host.hand(0, press_at(def, 0.001));
  wheel.host.advance(50);
  ASSERT_TRUE(wheel.host.status().hands.hand[0].active);
  EXPECT_FALSE(wheel.host.status().hands_taken);
  bool held = true;
  wheel.host.attach(std::make_unique<HeldHand>(held), 1);
  wheel.host.advance(1);
  EXPECT_TRUE(wheel.host.status().hands_taken);
  held = false;
  wheel.host.advance(1);
  EXPECT_FALSE(wheel.host.status().hands_taken);
}

// Attract throws with the pointers' own hands, beside whatever somebody leans on.
TEST(Potter, OnAPotThatIsShownADeviceThatSomebodyLeansOnNeitherWorksNorFeels) {
  const SceneDef def = small_scene();
  Stepped wheel(def);
  bool held = true, contact = false;
  auto leaned_on = std::make_unique<HeldHand>(held, press_at(def, 0.002), &contact);
  wheel.host.attach(std::move(leaned_on), 0);
  wheel.host.advance(50);
  ASSERT_TRUE(contact) << "a visitor's pot it works on";
  wheel.host.start(pot(def));
  wheel.host.show();
  wheel.host.hand(1, press_at(def, 0.001));
  bool shows = false;
  for (int n = 0; n < 200; ++n) {
    wheel.host.advance(1);
    shows = shows || wheel.host.status().feedback.hand[1].contact;
    ASSERT_FALSE(contact);
    ASSERT_FALSE(wheel.host.status().hands.hand[0].active);
  }
  EXPECT_TRUE(wheel.host.status().hands_taken) << "somebody is there";
  EXPECT_TRUE(wheel.host.status().shown);
  EXPECT_TRUE(shows) << "the hand that the screens lead";
  wheel.host.start(pot(def));
  wheel.host.advance(50);
  EXPECT_TRUE(contact) << "the next visitor's";
  EXPECT_FALSE(wheel.host.status().shown);
}

TEST(Potter, RowsThatAreWetAreSeenWetAndAPotWithoutSuchRowsHasNone) {
  SceneDef def = small_scene();
  Stepped plain(def);
  EXPECT_TRUE(plain.host.view().clay.wet.empty());
  def.moisture->sponge_height = 0.04;
  Stepped rows(def);
  HandInput hand = press_at(def, 0.001);
  rows.host.hand(0, hand);
  rows.host.water(true);
  rows.host.advance(2000);
  rows.host.collect();
  const auto& wet = rows.host.view().clay.wet;
  ASSERT_EQ(wet.size(), 64u);
  EXPECT_GT(wet[32], 0.8f) << "where the sponge was";
  EXPECT_LT(wet[4], 0.05f);
  EXPECT_LT(wet[60], 0.05f);
  const float before = wet[32];
  rows.host.water(false);
  rows.host.advance(20000);
  rows.host.collect();
  EXPECT_LT(rows.host.view().clay.wet[32], 0.8f * before) << "it dries";
}

/// A disc to build on, and a hand that rests a coil on its edge.
SceneDef floor_to_build_on(double coil = 0.013, int rows = 10) {
  SceneDef def = small_scene();
  def.clay.rows = rows;
  def.clay.height = def.clay.floor_thickness = 0.010;
  def.wheel.acceleration = 1000.0;
  def.volume.emplace();
  def.building.emplace().coil = coil;
  return def;
}
void rest_a_coil(SteppedWheel& host) {
  const SceneDef def = floor_to_build_on(host.view().coil.diameter);
  HandInput hand;
  hand.active = true;
  const ClayView& clay = host.view().clay;
  hand.position = {0.0, clay.rim_height() + 0.49 * def.building->coil,
                   def.clay.outer_radius - 0.5 * def.building->coil};
  host.hand(0, hand);
}
std::size_t places_laid(const SteppedWheel& host) {
  const auto& centre = host.view().coil.centre;
  return centre.size() - static_cast<std::size_t>(std::ranges::count(centre, 0.0f));
}

TEST(Potter, HalfARingOfCoilIsSeenWhereItLiesAndIsClayOnceItIsClosed) {
  Stepped wheel(floor_to_build_on());
  SteppedWheel& host = wheel.host;
  EXPECT_EQ(host.view().coil.diameter, 0.013);
  host.hold(InHand::coil);
  host.advance(500);
  host.wheel(2.5);
  rest_a_coil(host);
  host.advance(static_cast<int>(1000 * 3.14159 / 2.5));
  host.collect();
  ASSERT_EQ(host.view().coil.centre.size(), 128u);
  EXPECT_NEAR(static_cast<double>(places_laid(host)), 64.0, 4.0) << "half a turn";
  EXPECT_NEAR(host.view().coil.height, 0.010 + 0.0065, 1e-6);
  // The hand is at a quarter of a turn (z), and what it laid has turned on from there.
  const double here = 0.25 - host.view().clay.angle / (2 * 3.14159265);
  const auto centre = [&](double turn) {
    const double share = turn - std::floor(turn);
    return host.view().coil.centre[static_cast<std::size_t>(share * 128) % 128];
  };
  EXPECT_NEAR(centre(here + 0.05), 0.0485f, 0.003f) << "just laid";
  EXPECT_NEAR(centre(here + 0.45), 0.0485f, 0.003f);
  EXPECT_EQ(centre(here - 0.05), 0.0f) << "not yet";
  const double before = host.view().clay.rim_height();
  host.advance(1600);
  host.collect();
  EXPECT_TRUE(host.refresh_every_row());
  EXPECT_GT(host.view().clay.rim_height(), before + 0.010) << "the ring is closed";
}

TEST(Potter, ARingThatClosedIsAtOnceAWallAndNoCoil) {
  Stepped wheel(floor_to_build_on(0.03, 40));
  SteppedWheel& host = wheel.host;
  host.hold(InHand::coil);
  host.wheel(2.5);
  host.advance(500);
  rest_a_coil(host);
  const double floor = host.view().clay.rim_height();
  int seen = 0;
  for (int n = 0; n < 6000 && host.view().clay.rim_height() < floor + 0.005; ++n) {
    if (places_laid(host) > 0) {
      ++seen;
      ASSERT_NEAR(host.view().coil.height, floor + 0.015, 1e-6) << "tick " << n;
    }
    host.advance(1);
    host.collect();
  }
  EXPECT_GT(seen, 1000);
  EXPECT_EQ(places_laid(host), 0u) << "as soon as the rim is higher, not one ring higher";
  // A ring has 107 rows, more than the floor: with the next frame all of them are there.
  host.advance(16);
  host.collect();
  ASSERT_GT(host.view().clay.rows(), 140);
  for (int row = 0; row < host.view().clay.rows(); ++row)
    ASSERT_GT(host.view().clay.mean_inner(row) + (row < 40 ? 1.0 : 0.0), 0.01)
        << row << ": no lid lies on the mouth";
}

TEST(Potter, ACoilIsPutAwayByTheHandAndByANewPot) {
  Stepped wheel(floor_to_build_on());
  SteppedWheel& host = wheel.host;
  host.wheel(2.5);
  for (const bool held : {false, true, false}) {
    host.start(pot(floor_to_build_on()));
    host.advance(1);
    host.collect();
    host.hold(held ? InHand::coil : InHand::tool);
    rest_a_coil(host);
    host.advance(600);  // a hand is off for a moment when it takes a coil
    host.collect();
    EXPECT_EQ(places_laid(host) > 0, held);
    host.start(pot(floor_to_build_on()));
    rest_a_coil(host);
    host.advance(600);
    host.collect();
    EXPECT_EQ(places_laid(host), 0u) << "nothing lies on a new floor, and no coil is held";
  }
}

TEST(Potter, APotThatIsNotBuiltHasNoCoil) {
  Stepped wheel(small_scene());
  wheel.host.hold(InHand::coil);
  wheel.host.advance(500);
  wheel.host.hand(0, press_at(small_scene(), 0.001));
  wheel.host.advance(20);
  wheel.host.collect();
  EXPECT_EQ(wheel.host.view().coil.diameter, 0.0);
  EXPECT_TRUE(wheel.host.view().coil.centre.empty());
  EXPECT_TRUE(wheel.host.status().feedback.hand[0].contact) << "its tool works as ever";
}

TEST(Potter, ARowThatToreIsSeenTornAndHealsByGoingBack) {
  SceneDef def = small_scene();
  def.clay.inner_radius = 0.045;
  def.clay.wall_min = 0.002;
  def.walls.emplace();
  def.walls->tear_thickness = 0.0025;
  Stepped wheel(def);
  SteppedWheel& host = wheel.host;
  host.wheel(15);
  const auto pass = [&host](int ticks) {
    for (int n = 0; n < ticks; n += 20) {
      host.advance(20);
      host.collect();
    }
  };
  const auto torn = [&host] {
    int rows = 0;
    for (int j = 0; j < host.view().clay.rows(); ++j) rows += host.view().clay.torn(j) ? 1 : 0;
    return rows;
  };
  // Between two hands, until 1.5 mm are left of the wall, and stay.
  for (int n = 0; n < 170; ++n) {
    const double room = std::max(0.010 - 0.0001 * n, 0.0015);
    const double way = 0.5 * room + def.tool.radius, middle = 0.05;
    host.hand(0, {{middle + way, def.clay.height / 2, 0}, true, SideWish::outside});
    host.hand(1, {{middle - way, def.clay.height / 2, 0}, true, SideWish::inside});
    pass(20);
  }
  EXPECT_FALSE(host.view().clay.torn(5));
  host.hand(0, HandInput{});
  host.hand(1, HandInput{});
  pass(600);
  EXPECT_TRUE(host.status().feedback.torn);
  EXPECT_GT(torn(), 0);
  EXPECT_LT(torn(), 20);
  EXPECT_TRUE(host.view().clay.torn(def.clay.rows / 2) ||
              host.view().clay.torn(def.clay.rows / 2 - 1));
  EXPECT_LT(host.view().clay.torn_wall().value(), 0.0026);
  for (int n = 0; n < 4 && host.status().feedback.torn; ++n) {
    host.restore();
    pass(400);
  }
  EXPECT_FALSE(host.status().feedback.torn);
  EXPECT_EQ(torn(), 0);
  EXPECT_FALSE(host.view().clay.torn_wall());
}

TEST(Potter, OnceTheViewIsLevelAnUntouchedPotSendsNoRows) {
  SteppedWheel wheel_host;
  wheel_host.start(pot(small_scene()));
  for (int i = 0; i < 20; ++i) {
    wheel_host.advance(20);
    wheel_host.collect();
  }
  wheel_host.advance(100);
  EXPECT_EQ(wheel_host.collect(), 0);
}

TEST(Potter, AVisitOfOverAnHourKeepsNoReplay) {
  SteppedWheel wheel_host;
  SceneDef def;
  def.clay.rows = 8;
  def.clay.sectors = 16;
  wheel_host.start(pot(def));
  wheel_host.record("test", 7);
  const auto go_on = [&](int seconds) {
    for (int n = 0; n < seconds; n += 10) wheel_host.advance(10'000), wheel_host.collect();
  };
  go_on(4000);
  EXPECT_FALSE(wheel_host.replay(0).empty());
  go_on(10);
  EXPECT_TRUE(wheel_host.replay(0).empty());
}

TEST(Potter, ThePotThrownOnTheThreadIsTheOneItsReplayThrows) {
  LoopThread wheel_host;
  const SceneDef def = small_scene();
  wheel_host.start(pot(def));
  wheel_host.record("test", 7);
  wheel_host.wheel(15);
  for (int i = 0; i < 40; ++i) {
    wheel_host.hand(0, press_at(def, 0.0002 * i));
    wheel_host.water(i > 20);
    wheel_host.collect();
    std::this_thread::sleep_for(std::chrono::milliseconds(8));
  }
  std::uint64_t hash = 0, ticks = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) {
    hash = scene.state_hash();
    ticks = scene.counters().ticks;
  }));
  EXPECT_GT(ticks, 50u);
  const auto bytes = wheel_host.replay(hash);
  const auto replay = Replay::read(bytes, "test");
  ASSERT_TRUE(replay.has_value());
  EXPECT_EQ(replay->ticks.size(), ticks);
  const auto outcome = run_replay(*replay);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->replayed_hash, hash);
}

TEST(Potter, APotOnLoanComesBackAndTurnsOn) {
  LoopThread wheel_host;
  wheel_host.start(pot(small_scene()));
  std::uint64_t before = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) { before = scene.counters().ticks; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  std::uint64_t after = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& scene) { after = scene.counters().ticks; }));
  EXPECT_GT(after, before);
}

TEST(Potter, AFloodOfWishesNeitherBlocksNorLeaks) {
  LoopThread wheel_host;
  for (int i = 0; i < 40; ++i) {
    wheel_host.start(pot(small_scene()));
    for (int k = 0; k < 100; ++k) wheel_host.hand(k % 3, press_at(small_scene(), 1e-3));
  }
  EXPECT_TRUE(wheel_host.with_scene([](Scene&) {}));
}

/// A loop that stands still until it is told to turn.
class StalledPotter final : public WheelHost {
 public:
  StalledPotter() : WheelHost(0.02) {}
  LoopStatus status() const override { return core_.status(); }
  void turn() { core_.tick(1e-3); }

 private:
  void let_loop_turn() override {}
};

TEST(Potter, APotThatComesBackTooLateGoesOnTurning) {
  StalledPotter wheel_host;
  wheel_host.start(pot(small_scene()));
  wheel_host.turn();
  EXPECT_FALSE(wheel_host.with_scene([](Scene&) { FAIL() << "the loop has not answered"; }));
  wheel_host.turn();     // Hands the pot back, after the host gave up.
  wheel_host.collect();  // Puts it on again.
  wheel_host.turn();
  wheel_host.turn();
  EXPECT_EQ(wheel_host.status().ticks, 3u);
}

TEST(Potter, TheNextVisitorNeverGetsThePotOfTheLast) {
  StalledPotter wheel_host;
  wheel_host.start(pot(small_scene()));
  for (int i = 0; i < 5; ++i) wheel_host.turn();
  EXPECT_FALSE(wheel_host.with_scene([](Scene&) {}));
  wheel_host.turn();
  wheel_host.start(pot(small_scene()));
  wheel_host.turn();
  wheel_host.collect();
  wheel_host.turn();
  EXPECT_EQ(wheel_host.status().scene_serial, 2u);
  EXPECT_EQ(wheel_host.status().ticks, 2u);
}

TEST(Potter, APausedWheelStandsStill) {
  SteppedWheel wheel_host;
  wheel_host.start(pot(small_scene()));
  wheel_host.wheel(15);
  wheel_host.advance(500);
  const LoopStatus before = wheel_host.status();
  wheel_host.pause(true);
  wheel_host.advance(500);
  EXPECT_EQ(wheel_host.status().ticks, before.ticks);
  EXPECT_EQ(wheel_host.status().feedback.wheel_angle, before.feedback.wheel_angle);
  wheel_host.pause(false);
  wheel_host.advance(1);
  EXPECT_EQ(wheel_host.status().ticks, before.ticks + 1);
}

}  // namespace
}  // namespace onggi::loop::wheel_commands_test
