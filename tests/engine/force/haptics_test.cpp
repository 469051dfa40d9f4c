#include "engine/force/haptics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::force::haptics_test {
namespace {

constexpr double kMs = 0.001;
constexpr HapticLimits kHandle{.stiffness = 200.0, .max_force = 5.0};
constexpr double kGoing = 0.1;  // m/s

/// A newton that goes with a hand along x and that nobody's work explains, tick `n` of it.
Vec3 given_for_nothing(Haptics& haptics, int n, double share) {
  haptics.tool({kGoing * kMs * n, 0.0, 0.0}, kMs, kHandle);
  Touch touch;
  touch.push = {1.0, 0.0, 0.0};
  touch.stiffness = 1000.0;
  return haptics.feel(touch, share, kHandle);
}

TEST(Haptics, WhatTheCouplingGivesForNothingIsDampedOnItsWayToTheHand) {
  Haptics haptics;
  Vec3 felt;
  for (int n = 0; n < 500; ++n) felt = given_for_nothing(haptics, n, 1.0);
  const double damping = haptics.passivity().damping();
  EXPECT_GT(damping, 1.0);
  EXPECT_NEAR(felt.x, 200.0 * haptics.coupling().stretch().x - damping * kGoing, 0.02);
}

TEST(Haptics, TurnedOffNothingIsFeltThoughThereIsADebt) {
  Haptics haptics;
  for (int n = 0; n < 500; ++n) given_for_nothing(haptics, n, 1.0);
  ASSERT_LT(haptics.passivity().energy(), 0.0);
  for (int n = 500; n < 600; ++n) EXPECT_EQ(given_for_nothing(haptics, n, 0.0), Vec3{}) << n;
}

// The coupling's tool has no mass: a push on it would only move it.
TEST(Haptics, ABlowIsFeltByTheHandThatStruckForItsWholeTime) {
  for (const double stiffness : {19.0, 257.0, 1500.0}) {
    Haptics haptics;
    HapticLimits limits = kHandle;
    limits.stiffness = stiffness;
    double most = 0.0;
    int felt = 0;
    for (int n = 0; n < 100; ++n) {
      haptics.tool({0.07, 0.06, 0.0}, kMs, limits);
      if (n == 10) haptics.strike(66.0, {1.0, 0.0, 0.0});
      const Vec3 force = haptics.feel({}, 1.0, limits);
      most = std::max(most, force.x);
      felt += force.x > 0.0 ? 1 : 0;
      EXPECT_EQ(haptics.coupling().stretch(), Vec3{}) << "the tool stays where the hand is";
    }
    EXPECT_GT(most, 2.5) << stiffness;
    EXPECT_LT(most, BlowPulse::kMost);
    EXPECT_NEAR(felt, 23, 2) << stiffness;
  }
}

TEST(Haptics, AHandThatWasAwayHasNoDebt) {
  Haptics haptics;
  for (int n = 0; n < 500; ++n) given_for_nothing(haptics, n, 1.0);
  haptics.release();
  EXPECT_EQ(haptics.passivity().energy(), 0.0);
  EXPECT_EQ(haptics.coupling().stretch(), Vec3{});
}

TEST(Haptics, MostDampingIsAQuarterOfWhatItsLagBears) {
  // 45 g over half a tick of the hold and half of the window of 4 ms, and the delay's ticks.
  HapticLimits limits;
  EXPECT_NEAR(limits.most_damping(kMs), 0.25 * 0.045 / 0.0025, 1e-12);
  limits.delay = 3;
  limits.mass = 0.09;
  EXPECT_NEAR(limits.most_damping(kMs), 0.25 * 0.09 / 0.0055, 1e-12);
  EXPECT_NEAR(limits.most_damping(2.0 * kMs), 0.25 * 0.09 / 0.009, 1e-12);
}

}  // namespace
}  // namespace onggi::force::haptics_test
