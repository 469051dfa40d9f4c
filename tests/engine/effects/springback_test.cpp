#include "engine/effects/springback.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::springback_test {
namespace {

using namespace effects_test;

SceneDef small() {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 64;
  def.friction.reset();
  def.springback.emplace();
  return def;
}

// What is left of a dent: a finger presses for a tenth of a second, and lets go.
struct Groove {
  double pressed = 0.0, left = 0.0;
};
Groove groove(const SceneDef& def, double wait, double dt = 0.001) {
  Scene scene = made(def);
  Hands hands;
  hands.hand[0] = {{0.062, 0.1, 0}, true, SideWish::outside};
  const auto depth = [&] {
    return 0.055 - double{scene.clay().outer(scene.clay().first_row_above(0.1))[0]};
  };
  for (int n = 0; n < static_cast<int>(0.1 / dt); ++n) scene.step(hands, dt);
  Groove out;
  out.pressed = depth();
  hands.hand[0].active = false;
  for (int n = 0; n < static_cast<int>(wait / dt); ++n) scene.step(hands, dt);
  out.left = depth();
  return out;
}

TEST(Springback, APartOfThePressComesBackWhenTheHandGoes) {
  const SceneDef def = small();
  const Groove with = groove(def, 3.0);
  SceneDef without = def;
  without.springback.reset();
  const Groove dead = groove(without, 3.0);
  EXPECT_GT(dead.pressed, 3.5e-4);
  EXPECT_EQ(dead.left, dead.pressed);
  EXPECT_LT(with.left, with.pressed);
  EXPECT_LT(with.left, 0.9 * dead.left);
  EXPECT_GT(with.left, 0.99 * (1.0 - def.springback->share) * dead.left);  // what relaxed stays
}

TEST(Springback, ComesBackAsFastAtAnyTick) {
  const Groove fine = groove(small(), 0.2, 0.0005);
  const Groove coarse = groove(small(), 0.2, 0.004);
  EXPECT_NEAR(coarse.left, fine.left, 2e-5);
}

TEST(Springback, AFreshLumpOwesNothingOfTheOldOne) {
  Scene old = made(small()), fresh = made(small());
  Hands press;
  press.hand[0] = {{0.062, 0.1, 0}, true, SideWish::outside};
  const auto step = [](Scene& scene, const Hands& hands, int ticks) {
    for (int n = 0; n < ticks; ++n) scene.step(hands, 0.001);
  };
  step(old, press, 100);
  Hands renew;
  renew.renew = true;
  step(old, renew, 1);
  step(old, {}, 1000);
  ASSERT_EQ(old.clay().hash(), fresh.clay().hash());
  step(old, press, 100);
  step(fresh, press, 100);
  step(old, {}, 2000);
  step(fresh, {}, 2000);
  for (int j = 0; j < fresh.clay().rows(); ++j)
    for (std::size_t i = 0; i < fresh.clay().outer(j).size(); ++i)
      ASSERT_NEAR(old.clay().outer(j)[i], fresh.clay().outer(j)[i], 1e-7) << j << ' ' << i;
}

TEST(Springback, NoRowEverGoesBeyondWhereItWasPressedFrom) {
  SceneDef def = small();
  def.springback->share = 0.5;
  def.springback->time = 0.01;
  Scene scene = made(def);
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.hand[0] = {{}, true, SideWish::outside};
  for (int n = 0; n < 6000; ++n) {
    hands.hand[0].position = {0.0635 - 0.003 * ((n / 500) % 2), 0.1 + 1e-6 * n, 0};
    scene.step(hands, 0.001);
    if (n % 50 != 0) continue;
    for (int j = 0; j < scene.clay().rows(); ++j)
      for (const float r : scene.clay().outer(j)) ASSERT_LE(r, 0.055f);
  }
}

TEST(Springback, IsPassiveAHandThatGoesInAndOutGetsNoWorkOutOfTheClay) {
  for (const double rate : {0.5, 2.0, 10.0, 40.0}) {
    SceneDef def = small();
    def.springback->share = 0.5;
    def.guard.engage_time = 0.05;
    def.guard.max_force = 20.0;
    def.guard.max_slew = 1e5;
    Scene scene = made(def);
    Hands hands;
    hands.hand[0] = {{0.0640, 0.1, 0}, true, SideWish::outside};
    double work = 0.0;  // of the hand on the clay
    double last = hands.hand[0].position.x;
    const int period = static_cast<int>(1000 / rate);
    for (int n = 0; n < 20 * period; ++n) {
      const double turns = static_cast<double>(n) / period;
      hands.hand[0].position.x = 0.0630 - 0.001 * portable::cos(2 * portable::kPi * turns);
      const Feedback felt = scene.step(hands, 0.001);
      work -= felt.hand[0].force.x * (hands.hand[0].position.x - last);
      last = hands.hand[0].position.x;
      if (n % period == period - 1) {
        EXPECT_GE(work, -1e-9) << rate << " Hz, turn " << turns;
      }
    }
    EXPECT_GT(work, 0.0);
  }
}

TEST(Springback, SleepsOnceAllIsBack) {
  const SceneDef def = small();
  Result<Clay> clay = Clay::create(def.clay);
  clay->keep_areas();
  clay->keep_displacements();
  Springback springback(*clay);
  EXPECT_TRUE(springback.asleep());
  for (int i = 0; i < 64; ++i) clay->displacements(false)->row(50)[i] = 1e-4f;
  clay->displacements(false)->mark(50, {0, 8});
  springback.load(*def.springback, *clay, WallSide::outside);
  clay->displacements(false)->clear(clay->stored());
  EXPECT_FALSE(springback.asleep());
  int ticks = 0;
  for (; !springback.asleep() && ticks < 10000; ++ticks)
    springback.come_back(*def.springback, *clay, 0.001, 0.0);
  EXPECT_LT(ticks, 2500);
  EXPECT_NEAR(clay->outer(50)[3], 0.055 + 0.15 * 1e-4, 1e-7);
}

TEST(Springback, WithVolumeAndWallsNoClayIsLost) {
  SceneDef def = small();
  def.volume.emplace();
  def.walls.emplace();
  expect_clay_kept(def, 41, 20000);
}

// Clay that has hardened where it was pressed does not come back, and does not wait for its chance.
TEST(Springback, WhatHardensForgetsAsFastAsSoftClayComesBack) {
  const SpringbackDef def;
  const auto back_after = [&](double hard) {
    ClayDef lump;
    lump.rows = 20;
    lump.sectors = 16;
    Clay clay = std::move(*Clay::create(lump));
    clay.keep_areas();
    clay.keep_displacements();
    clay.areas()->keep_firm();
    const int row = clay.rows() - 3;
    Displacements& moved = *clay.displacements(false);
    moved.mark(row, {0, 2});
    for (int i = 0; i < 16; ++i) {
      moved.row(clay.stored(row))[i] = 0.001f;
      clay.outer_mut(row)[static_cast<std::size_t>(i)] -= 0.001f;
    }
    Springback springback(clay);
    springback.load(def, clay, WallSide::outside);
    const double pressed = double{clay.outer(row)[5]};
    clay.areas()->harden_all(true, true);
    for (double t = 0.0; t < hard - 1e-9; t += 0.001) springback.come_back(def, clay, 0.001, 0.0);
    EXPECT_EQ(double{clay.outer(row)[5]}, pressed);
    clay.areas()->harden_all(false, false);
    for (int n = 0; n < 20'000 && !springback.asleep(); ++n)
      springback.come_back(def, clay, 0.001, 0.0);
    EXPECT_TRUE(springback.asleep());
    return double{clay.outer(row)[5]} - pressed;
  };
  const double owed = 0.001 * def.share;
  EXPECT_NEAR(back_after(0.0), owed, 0.01 * owed);
  EXPECT_NEAR(back_after(def.time), std::exp(-1.0) * owed, 0.1 * owed);
  EXPECT_EQ(back_after(20.0 * def.time), 0.0);
}

}  // namespace
}  // namespace onggi::effects::springback_test
