// Where blows fell and hands smoothed, on the pot as it stands.
#include "engine/effects/prints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"
#include "engine/scene/replay.h"
#include "tests/engine/effects/building_hands.h"

namespace onggi::effects::prints_test {
namespace {

using namespace effects_test;

constexpr double kOuter = 0.060;

SceneDef wall() {
  SceneDef def;
  each_effect(def, [](auto& effect) { effect.reset(); });
  def.clay.rows = 120;
  def.clay.sectors = 90;
  def.clay.height = 0.120;
  def.clay.floor_thickness = 0.010;
  def.clay.outer_radius = kOuter;
  def.clay.inner_radius = kOuter - 0.008;
  def.clay.wall_min = 0.001;
  def.wheel.acceleration = 1000.0;
  def.volume.emplace();
  def.beating.emplace();
  def.prints.emplace().paddle = PrintsDef::cord;
  return def;
}

HandInput paddle(double height, double angle, double out = kOuter + 0.012) {
  HandInput hand;
  hand.position = {out * portable::cos(angle), height, out * portable::sin(angle)};
  hand.active = hand.paddle = true;
  hand.anvil = 1.0;
  return hand;
}

void strike(Scene& scene, const HandInput& hand) {
  Hands hands;
  hands.hand[0] = hand;
  scene.step(hands, 0.001);
  hands.hand[0].blow = true;
  scene.step(hands, 0.001);
  hands.hand[0].blow = false;
  for (int n = 0; n < 5; ++n) scene.step(hands, 0.001);
}

// A hand on the outside, pressed 1 mm in, which goes up from `low` to `high`.
void smooth(Scene& scene, double low, double high, double angle, double seconds,
            double wheel_speed = 0.0) {
  Hands hands;
  hands.wheel_speed = wheel_speed;
  const int ticks = static_cast<int>(1000 * seconds);
  for (int n = 0; n < ticks; ++n) {
    const double out = kOuter + 0.007, y = low + (high - low) * n / ticks;
    hands.hand[0] = {
        {out * portable::cos(angle), y, out * portable::sin(angle)}, true, SideWish::outside};
    scene.step(hands, 0.001);
  }
  hands.hand[0].active = false;
  for (int n = 0; n < 5; ++n) scene.step(hands, 0.001);
}

TEST(Prints, ABlowAgainstAnAnvilLeavesThePaddleOutsideAndTheAnvilInsideWhereItFell) {
  Scene scene = made(wall());
  EXPECT_TRUE(scene.prints().empty());
  strike(scene, paddle(0.06, 0.7));
  const std::vector<Print> prints = scene.prints();
  ASSERT_EQ(prints.size(), 2u);
  EXPECT_EQ(prints[0].kind, Print::paddle);
  EXPECT_EQ(prints[0].side, WallSide::outside);
  EXPECT_EQ(prints[1].kind, Print::anvil);
  EXPECT_EQ(prints[1].side, WallSide::inside);
  for (const Print& print : prints) {
    // The wall under it gets 3e-4 m higher.
    EXPECT_NEAR(0.5 * (print.low + print.high), 0.06, 2e-4);
    EXPECT_NEAR(print.high - print.low, 2.0 * 0.02, 5e-4);
    EXPECT_NEAR(print.angle, 0.7, 1e-6);
    EXPECT_NEAR(print.half, 0.02 / kOuter, 0.01);
    EXPECT_EQ(print.tall, double{0.02f});
    EXPECT_GT(print.deep, 5e-5);
    EXPECT_LT(print.deep, 2e-3);
  }
}

TEST(Prints, AtTheRimLiesWhatOfTheFaceIsOnTheWall) {
  Scene scene = made(wall());
  strike(scene, paddle(0.115, 0.0));
  ASSERT_EQ(scene.prints().size(), 2u);
  const Print print = scene.prints()[0];
  EXPECT_NEAR(print.high, scene.clay().rim_height(), 1e-9);
  EXPECT_NEAR(print.from, -1.0, 1e-6);
  EXPECT_NEAR(print.to, 0.005 / 0.02, 1e-6);
  EXPECT_NEAR(print.high - print.low, 0.025, 5e-4);
}

TEST(Prints, FromInsideItIsTheOtherWayRound) {
  Scene scene = made(wall());
  HandInput inside = paddle(0.06, -2.0, kOuter - 0.02);
  inside.side = SideWish::inside;
  strike(scene, inside);
  const std::vector<Print> prints = scene.prints();
  ASSERT_EQ(prints.size(), 2u);
  for (const Print& print : prints)
    EXPECT_EQ(print.kind == Print::paddle, print.side == WallSide::inside);
}

TEST(Prints, WithAHandBehindTheWallThereAreNoRingsAndWithNothingNoPrint) {
  Scene scene = made(wall());
  HandInput alone = paddle(0.06, 0.0);
  alone.anvil = 0.0;
  strike(scene, alone);
  EXPECT_TRUE(scene.prints().empty());
  Hands hands;
  hands.hand[0] = alone;
  hands.hand[1] = {{kOuter - 0.015, 0.06, 0.0}, true, SideWish::inside};
  for (int n = 0; n < 20; ++n) scene.step(hands, 0.001);
  hands.hand[0].blow = true;
  scene.step(hands, 0.001);
  ASSERT_FALSE(scene.prints().empty());
  EXPECT_EQ(scene.prints()[0].kind, Print::paddle);
  for (const Print& print : scene.prints()) EXPECT_NE(print.kind, Print::anvil);
}

TEST(Prints, TheClayTakesThemAlongAsItGetsHigher) {
  Scene scene = made(wall());
  strike(scene, paddle(0.1, 0.0));
  const double before = scene.clay().rim_height();
  const double share = scene.prints()[0].low / before;
  for (int n = 0; n < 150; ++n) strike(scene, paddle(0.03 + 0.0004 * (n % 50), 0.9 * n));
  const double rim = scene.clay().rim_height();
  ASSERT_GT(rim, before + 0.004);
  const Print first = scene.prints()[0];
  EXPECT_NEAR(rim - first.low, before - share * before, 0.001) << "it keeps its clay above";
  EXPECT_GT(first.low, share * before + 0.003);
}

// A trimmer goes from `low` to `high` and 2 mm in, on a turning wheel.
void trim(Scene& scene, double low, double high, double seconds) {
  Hands hands;
  hands.wheel_speed = 18.0;
  for (std::uint8_t n = 0; n < scene.def().tools.size(); ++n)
    if (scene.def().tools[n].name == "loop_trimmer") hands.hand[0].tool = n + 1;
  ASSERT_GT(hands.hand[0].tool, 0);
  hands.hand[0].active = true;
  hands.hand[0].side = SideWish::outside;
  const int ticks = static_cast<int>(1000 * seconds);
  for (int n = 0; n < ticks; ++n) {
    hands.hand[0].position = {kOuter + 0.006, low + (high - low) * n / ticks, 0.0};
    scene.step(hands, 0.001);
  }
  hands.hand[0].active = false;
  wait(scene, 1.0);
}

TEST(Prints, WhatATrimmerTakesBelowLeavesAPrintOnItsClayAndUndoDoesToo) {
  Scene scene = made(wall());
  strike(scene, paddle(0.09, 0.0));
  strike(scene, paddle(0.05, 3.0));
  wait(scene, 1.0);
  const double clay = scene.clay().volume(), rim = scene.clay().rim_height();
  const std::vector<Print> before = scene.prints();
  trim(scene, 0.02, 0.04, 2.5);
  trim(scene, 0.04, 0.06, 2.5);
  ASSERT_LT(scene.clay().volume(), 0.95 * clay);
  const std::vector<Print> after = scene.prints();
  const double up = scene.clay().rim_height() - rim;
  ASSERT_NEAR(up, 0.0, 1e-3);
  for (std::size_t n = 0; n < before.size(); ++n) {
    // No row above the trimmer moved but with the rim.
    const double near = before[n].low > 0.069 ? 1e-5 : 1e-3;
    EXPECT_NEAR(after[n].low, before[n].low + up, near) << n;
    EXPECT_NEAR(after[n].high, before[n].high + up, near) << n;
  }
  undo(scene);
  undo(scene);
  ASSERT_NEAR(scene.clay().volume() / clay, 1.0, 1e-6);
  const std::vector<Print> again = scene.prints();
  ASSERT_EQ(again.size(), before.size());
  for (std::size_t n = 0; n < before.size(); ++n) {
    EXPECT_NEAR(again[n].low, before[n].low, 2e-6) << n;
    EXPECT_NEAR(again[n].high, before[n].high, 2e-6) << n;
  }
}

TEST(Prints, NoClayMovesByThem) {
  Scene kept = made(wall());
  SceneDef without = wall();
  without.prints.reset();
  Scene bare = made(without);
  for (Scene* scene : {&kept, &bare})
    for (int n = 0; n < 12; ++n) strike(*scene, paddle(0.03 + 0.005 * n, 0.8 * n));
  EXPECT_EQ(kept.clay().hash(), bare.clay().hash());
  EXPECT_NE(kept.state_hash(), bare.state_hash());
  EXPECT_TRUE(bare.prints().empty());
}

TEST(Prints, AHandThatRestsWhileThePotTurnsSmoothsARingAndOneThatGoesUpAStack) {
  Scene scene = made(wall());
  smooth(scene, 0.06, 0.06, 0.0, 0.1);
  EXPECT_TRUE(scene.prints().empty()) << "there was nothing to smooth";
  strike(scene, paddle(0.06, 0.0));
  smooth(scene, 0.06, 0.06, 0.0, 1.5, 8.0);
  std::vector<Print> prints = scene.prints();
  ASSERT_EQ(prints.size(), 3u);
  EXPECT_EQ(prints[2].kind, Print::smoothed);
  EXPECT_EQ(prints[2].side, WallSide::outside);
  EXPECT_NEAR(prints[2].half, portable::kPi, 1e-6);
  EXPECT_NEAR(0.5 * (prints[2].low + prints[2].high), 0.06, 5e-4);
  EXPECT_NEAR(prints[2].high - prints[2].low, 0.008, 1e-3);
  smooth(scene, 0.04, 0.08, 1.0, 1.0);
  prints = scene.prints();
  ASSERT_GE(prints.size(), 6u);
  ASSERT_LE(prints.size(), 13u) << "not one for each tick";
  double low = 1.0, high = 0.0;
  for (std::size_t n = 3; n < prints.size(); ++n) {
    low = std::min(low, prints[n].low), high = std::max(high, prints[n].high);
    EXPECT_NEAR(prints[n].half, 0.004 / kOuter, 0.02);
  }
  EXPECT_NEAR(low, 0.036, 0.002);
  EXPECT_NEAR(high, 0.084, 0.002);
}

TEST(Prints, WhatAHandSmoothsEndsAtTheRimAsTheWallDoes) {
  Scene scene = made(wall());
  strike(scene, paddle(0.11, 0.0));
  const double at = scene.clay().rim_height() - 0.003;
  smooth(scene, at, at, 0.0, 0.3, 8.0);
  const Print hand = scene.prints().back();
  ASSERT_EQ(hand.kind, Print::smoothed);
  EXPECT_NEAR(hand.high, scene.clay().rim_height(), 1e-6);
  EXPECT_NEAR(hand.from, -1.0, 1e-6);
  EXPECT_NEAR(hand.to, 0.75, 0.05) << "the rim is 3 mm above its middle, of 4";
  EXPECT_NEAR((hand.high - hand.low) / (hand.to - hand.from), 0.004, 2e-4);
}

TEST(Prints, UndoTakesBackTheBlowsOfAStrokeAndItsSmoothing) {
  Scene scene = made(wall());
  strike(scene, paddle(0.06, 0.0));
  wait(scene, 1.0);
  strike(scene, paddle(0.05, 1.0));
  strike(scene, paddle(0.07, 1.2));
  wait(scene, 1.0);
  smooth(scene, 0.06, 0.06, 0.0, 0.1);
  wait(scene, 1.0);
  EXPECT_EQ(scene.prints().size(), 7u);
  undo(scene);
  EXPECT_EQ(scene.prints().size(), 6u);
  undo(scene);
  ASSERT_EQ(scene.prints().size(), 2u);
  EXPECT_NEAR(scene.prints()[0].angle, 0.0, 1e-6);
  undo(scene);
  EXPECT_TRUE(scene.prints().empty());
}

TEST(Prints, AFreshLumpHasNoneAndUndoBringsThoseOfTheLumpBefore) {
  Scene scene = made(wall());
  strike(scene, paddle(0.06, 0.0));
  wait(scene, 1.0);
  Hands renew;
  renew.renew = true;
  wait(scene, 1.0, renew);
  EXPECT_TRUE(scene.prints().empty());
  strike(scene, paddle(0.06, 2.0));
  EXPECT_EQ(scene.prints().size(), 2u);
  wait(scene, 1.0);
  undo(scene);
  undo(scene);
  ASSERT_EQ(scene.prints().size(), 2u);
  EXPECT_NEAR(scene.prints()[0].angle, 0.0, 1e-6);
}

TEST(Prints, TheOldestGoWhereThereAreTooMany) {
  const SceneDef def = wall();
  Clay clay = std::move(*Clay::create(def.clay));
  clay.keep_areas();
  Volume volume(clay);
  Prints prints(clay.room());
  RowTick tick;
  const StageWork work{def, clay, tick, &volume};
  Print print;
  print.low = 0.05, print.high = 0.07, print.deep = 0.001;
  for (std::size_t n = 0; n < Prints::kMost + 3; ++n) {
    print.angle = 0.001 * static_cast<double>(n);
    prints.strike(work, print);
  }
  const std::vector<Print> seen = prints.seen(clay, volume);
  ASSERT_EQ(seen.size(), Prints::kMost);
  EXPECT_NEAR(seen.front().angle, 0.003, 1e-6);
  EXPECT_NEAR(seen.back().angle, 0.001 * (Prints::kMost + 2), 1e-6);
  print.deep = 0.0;
  prints.strike(work, print);
  EXPECT_NEAR(prints.seen(clay, volume).back().angle, seen.back().angle, 1e-6)
      << "a face that only lies on what stands out leaves nothing";
}

TEST(Prints, HandsThatScrubForLongDriveNoBlowOut) {
  const SceneDef def = wall();
  Clay clay = std::move(*Clay::create(def.clay));
  clay.keep_areas();
  Volume volume(clay);
  Prints prints(clay.room());
  RowTick tick;
  const StageWork work{def, clay, tick, &volume};
  Print print;
  print.low = 0.01, print.high = 0.05, print.deep = 0.001;
  prints.strike(work, print);
  HandThere& once = tick.hand[0];
  once.normal = 1.0, once.on_wall = true;
  once.at = {kOuter, 0.11, 0.0};
  prints.run(work);
  // Two hands at 4 Hz from 40 to 100 mm, 6 rad/s, 40 s.
  for (int n = 0; n < 40000; ++n) {
    const double angle = 0.006 * n, y = 0.07 + 0.03 * portable::sin(0.0251 * n);
    for (std::size_t hand = 0; hand < 2; ++hand) {
      tick.hand[hand] = {};
      tick.hand[hand].normal = 1.0, tick.hand[hand].on_wall = true;
      tick.hand[hand].side = hand == 0 ? WallSide::outside : WallSide::inside;
      tick.hand[hand].at = {kOuter * portable::cos(angle), y, kOuter * portable::sin(angle)};
    }
    prints.run(work);
  }
  const std::vector<Print> seen = prints.seen(clay, volume);
  EXPECT_LE(seen.size(), Prints::kMostSmoothed + 1);
  ASSERT_EQ(seen[0].kind, Print::paddle);
  EXPECT_NEAR(seen[1].high, 0.114, 1e-4) << "nothing lies over it, so it stays too";
  EXPECT_NEAR(seen[1].angle, 0.0, 1e-6);
}

TEST(Prints, ABlowEndsAFieldAndSoDoesAnUndoStep) {
  const auto fields = [](const Scene& scene) {
    return std::ranges::count(scene.prints(), Print::smoothed, &Print::kind);
  };
  Scene scene = made(wall());
  strike(scene, paddle(0.06, 0.0));
  Hands hands;
  for (int n = 0; n < 200; ++n) {
    hands.hand[0] = {{kOuter + 0.0075 - 1e-5 * n, 0.06, 0.0}, true, SideWish::outside};
    if (n > 90 && n < 110) hands.hand[1] = paddle(0.09, 2.0);
    hands.hand[1].active = n > 90 && n < 110;
    hands.hand[1].blow = n == 100;
    scene.step(hands, 0.001);
  }
  const std::vector<Print> prints = scene.prints();
  ASSERT_EQ(prints.size(), 6u);
  EXPECT_EQ(prints[2].kind, Print::smoothed);
  EXPECT_EQ(prints[3].kind, Print::paddle);
  EXPECT_EQ(prints[5].kind, Print::smoothed) << "what is smoothed from now on lies over the blow";
  Scene rests = made(wall());
  strike(rests, paddle(0.06, 0.0));
  wait(rests, 1.0);
  Hands deeper;
  for (int n = 0; n < 4000; ++n) {
    deeper.hand[0] = {{kOuter + 0.0075 - 1e-6 * n, 0.06, 0.0}, true, SideWish::outside};
    rests.step(deeper, 0.001);
  }
  wait(rests, 1.0);
  EXPECT_EQ(fields(rests), 2) << "a touch of 4 s is two steps";
  undo(rests);
  EXPECT_EQ(fields(rests), 1);
}

TEST(Prints, EachHandAndEachSideHasAFieldOfItsOwn) {
  Scene scene = made(wall());
  strike(scene, paddle(0.06, 0.0));
  Hands hands;
  for (int n = 0; n < 100; ++n) {
    hands.hand[0] = {{kOuter + 0.007, 0.06, 0.0}, true, SideWish::outside};
    hands.hand[1] = {{kOuter - 0.015, 0.06, 0.0}, true, SideWish::inside};
    scene.step(hands, 0.001);
  }
  const std::vector<Print> prints = scene.prints();
  ASSERT_EQ(prints.size(), 4u);
  EXPECT_EQ(prints[2].kind, Print::smoothed);
  EXPECT_EQ(prints[3].kind, Print::smoothed);
  EXPECT_NE(prints[2].side, prints[3].side);
  // The same hand on the other side.
  const SceneDef def = wall();
  Clay clay = std::move(*Clay::create(def.clay));
  clay.keep_areas();
  Volume volume(clay);
  Prints kept(clay.room());
  RowTick tick;
  const StageWork work{def, clay, tick, &volume};
  Print print;
  print.low = 0.04, print.high = 0.08, print.deep = 0.001;
  kept.strike(work, print);
  tick.hand[0].normal = 1.0, tick.hand[0].on_wall = true;
  tick.hand[0].at = {kOuter, 0.06, 0.0};
  kept.run(work);
  tick.hand[0].side = WallSide::inside;
  kept.run(work);
  EXPECT_EQ(kept.seen(clay, volume).size(), 3u);
}

TEST(Prints, TheStatesHashTellsThePlaceOfAPrint) {
  const SceneDef def = wall();
  Clay clay = std::move(*Clay::create(def.clay));
  clay.keep_areas();
  Volume volume(clay);
  RowTick tick;
  const StageWork work{def, clay, tick, &volume};
  Print print;
  print.low = 0.04, print.high = 0.08, print.half = 0.3, print.deep = 0.001;
  print.wide = print.tall = 0.02;
  const auto hash = [&](auto change) {
    Prints prints(clay.room());
    Print other = print;
    change(other);
    prints.strike(work, other);
    StateHash all;
    prints.add_to(all, clay);
    return all.value();
  };
  const auto same = [](Print&) {};
  EXPECT_EQ(hash(same), hash(same));
  EXPECT_NE(hash(same), hash([](Print& each) { each.low += 0.001; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.high += 0.001; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.angle = 1.0; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.half = 0.2; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.wide = 0.01; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.tall = 0.01; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.deep = 0.002; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.kind = Print::anvil; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.side = WallSide::inside; }));
  EXPECT_NE(hash(same), hash([](Print& each) { each.left = true; }));
}

TEST(Prints, OnlyTheWallAboveTheFloorIsPrintedAndNoDeeperThanTheWallGives) {
  for (const double height : {0.012, 0.0, -0.005}) {
    Scene scene = made(wall());
    strike(scene, paddle(height, 0.0));
    for (const Print& print : scene.prints()) {
      EXPECT_GE(print.low, scene.clay().floor_top() - 1e-4) << height;
      EXPECT_LE(print.deep, 0.25 * 0.008) << height;
      EXPECT_GT(print.from, -1.0) << height;
    }
  }
  for (const double over : {0.0, 0.01, 0.0185, 0.0195}) {
    Scene scene = made(wall());
    strike(scene, paddle(scene.clay().rim_height() + over, 0.0));
    for (const Print& print : scene.prints()) EXPECT_LE(print.deep, 0.25 * 0.008) << over;
  }
}

TEST(Prints, AMetreOfTheFaceIsAMetreOfTheWallOnBothSides) {
  SceneDef def = wall();
  def.clay.outer_radius = 0.0668;
  def.clay.inner_radius = 0.040;
  Scene scene = made(def);
  strike(scene, paddle(0.06, 0.0, 0.0668 + 0.012));
  ASSERT_EQ(scene.prints().size(), 2u);
  for (const Print& print : scene.prints()) {
    const double radius = print.side == WallSide::outside ? 0.0668 : 0.040;
    EXPECT_NEAR(print.wide / (print.half * radius), 1.0, 0.02);
  }
}

TEST(Prints, ABlowTellsOnWhichSideOfTheVisitorItFellHoweverThePotIsTurned) {
  Scene scene = made(wall());
  strike(scene, paddle(0.06, 0.5));
  strike(scene, paddle(0.06, 3.0));
  Hands turn;
  turn.wheel_speed = 2.0;
  wait(scene, 1.0, turn);
  wait(scene, 1.0);
  strike(scene, paddle(0.06, 0.5));
  const std::vector<Print> prints = scene.prints();
  ASSERT_EQ(prints.size(), 6u);
  ASSERT_GT(std::fabs(prints[4].angle - prints[0].angle), 0.5) << "another place of the clay";
  EXPECT_FALSE(prints[0].left);
  EXPECT_TRUE(prints[2].left);
  EXPECT_FALSE(prints[4].left);
}

TEST(Prints, AReplayBringsThemAll) {
  const SceneDef def = wall();
  Scene scene = made(def);
  ReplayWriter writer(def, "onggi", 1);
  Hands hands;
  hands.wheel_speed = 2.0;
  for (int n = 0; n < 1200; ++n) {
    hands.hand[0] = paddle(0.03 + 5e-5 * n, 0.0);
    hands.hand[0].blow = n % 100 > 80;
    scene.step(hands, 0.001);
    writer.tick({hands, 0.001});
  }
  const auto replay = Replay::read(writer.finish(scene.state_hash()), "test");
  ASSERT_TRUE(replay);
  EXPECT_EQ(replay->def.prints->paddle, PrintsDef::cord);
  std::unique_ptr<Scene> again;
  const auto outcome = run_replay(*replay, &again);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->recorded_hash, outcome->replayed_hash);
  const std::vector<Print> first = scene.prints(), second = again->prints();
  ASSERT_EQ(first.size(), 24u);
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t n = 0; n < first.size(); ++n) {
    EXPECT_EQ(first[n].low, second[n].low);
    EXPECT_EQ(first[n].angle, second[n].angle);
  }
}

TEST(PaddleFace, HasANameAndOtherWordsNameNone) {
  ASSERT_EQ(paddle_faces().size(), 3u);
  EXPECT_EQ(find_paddle_face("plain"), PrintsDef::plain);
  EXPECT_EQ(find_paddle_face("cord"), PrintsDef::cord);
  EXPECT_EQ(find_paddle_face("grid"), PrintsDef::grid);
  EXPECT_EQ(find_paddle_face("Grid"), std::nullopt);
}

}  // namespace
}  // namespace onggi::effects::prints_test
