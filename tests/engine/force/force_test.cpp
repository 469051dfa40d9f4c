#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "engine/force/friction.h"
#include "engine/force/guard.h"

namespace onggi {
namespace {

constexpr GuardLimits kLimits{3.3, 600.0, 0.5};

// --- Friction (correction 15).

TEST(Friction, IsSilentWithoutSlipAndSettlesAtMuTimesN) {
  const Vec3 reaction{2, 0, 0};
  EXPECT_EQ(friction_force(reaction, 2.0, {0, 0, 0}, 0.35, 0.01), (Vec3{0, 0, 0}));
  const Vec3 fast = friction_force(reaction, 2.0, {0, 0, 5.0}, 0.35, 0.01);
  EXPECT_NEAR(fast.z, -0.7, 1e-5);
  const Vec3 half = friction_force(reaction, 2.0, {0, 0, 0.01}, 0.35, 0.01);
  EXPECT_NEAR(half.z, -0.7 / std::sqrt(2.0), 1e-12);  // smooth through rest
}

TEST(Friction, ATurningWheelDragsARestingHandAlong) {
  const Vec3 touch{0.055, 0.1, 0};
  const Vec3 slip = Vec3{} - clay_velocity(touch, 20.0);  // hand at rest
  EXPECT_NEAR(slip.z, -1.1, 1e-12);
  EXPECT_GT(friction_force({1, 0, 0}, 1.0, slip, 0.35, 0.01).z, 0.0);  // from x towards z
}

RC_GTEST_PROP(FrictionProperty, NeverExceedsMuNAndNeverPushesAlongTheSlip, ()) {
  const auto some = [] { return *rc::gen::inRange(-1000, 1001) * 0.003; };
  const Vec3 reaction{some(), some(), some()};
  const Vec3 slip{some(), some(), some()};
  const double normal = *rc::gen::inRange(0, 1000) * 0.01;
  const Vec3 f = friction_force(reaction, normal, slip, 0.35, 0.01);
  RC_ASSERT(length(f) <= 0.35 * normal + 1e-12);
  RC_ASSERT(dot(f, slip) <= 1e-9);
  RC_ASSERT(std::fabs(dot(f, reaction)) <= 1e-9 * (1.0 + length(reaction) * normal));
}

// --- Guard: correction 22 and the last word.

RC_GTEST_PROP(GuardProperty, WhateverGoesInItIsFiniteSmallAndSlow, ()) {
  Guard guard;
  Vec3 last;
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int n = 0; n < 200; ++n) {
    const auto some = [&] {
      return *rc::gen::element(0.0, 1.0, -2.5, 1e9, -1e308, 5e-324, inf, nan);
    };
    bool ok = true;
    if (*rc::gen::inRange(0, 20) == 0) guard.release();
    const Vec3 wanted{some(), some(), some()};
    const Vec3 out = guard.step(wanted, 0.001, kLimits, ok);
    RC_ASSERT(ok == is_finite(wanted));
    RC_ASSERT(is_finite(out));
    RC_ASSERT(length(out) <= 3.3 * (1 + 1e-12));
    RC_ASSERT(length(out - last) <= 0.6 * (1 + 1e-9));
    last = out;
  }
}

TEST(Guard, RampsAHandInOverTheEngageTime) {
  Guard guard;
  bool ok = true;
  guard.step({0, 0, 0}, 0.001, kLimits, ok);
  for (int n = 0; n < 249; ++n) guard.step({1, 0, 0}, 0.001, kLimits, ok);
  EXPECT_NEAR(guard.force().x, 0.5, 1e-9);
  for (int n = 0; n < 300; ++n) guard.step({1, 0, 0}, 0.001, kLimits, ok);
  EXPECT_NEAR(guard.force().x, 1.0, 1e-12);
}

TEST(Guard, AHandThatArrivesDeepInTheClayFeelsNothingUntilTheForceWantedIsSmall) {
  Guard guard;
  guard.release();
  bool ok = true;
  for (int n = 0; n < 1000; ++n) guard.step({3, 0, 0}, 0.001, kLimits, ok);
  EXPECT_EQ(guard.force().x, 0.0);
  guard.step({0.2, 0, 0}, 0.001, kLimits, ok);
  for (int n = 0; n < 600; ++n) guard.step({3, 0, 0}, 0.001, kLimits, ok);
  EXPECT_NEAR(guard.force().x, 3.0, 1e-12);
}

TEST(Guard, ANumberThatIsNoneTakesTheForceToZeroAtTheSlewLimitAndEngagesAgain) {
  Guard guard;
  bool ok = true;
  for (int n = 0; n < 1000; ++n) guard.step({0.3, 0, 0}, 0.001, kLimits, ok);
  for (int n = 0; n < 1000; ++n) guard.step({3, 0, 0}, 0.001, kLimits, ok);
  EXPECT_NEAR(guard.force().x, 3.0, 1e-12);
  guard.step({std::numeric_limits<double>::quiet_NaN(), 0, 0}, 0.001, kLimits, ok);
  EXPECT_FALSE(ok);
  EXPECT_NEAR(guard.force().x, 2.4, 1e-9);
  for (int n = 0; n < 4; ++n) guard.step({0, 0, 0}, 0.001, kLimits, ok);
  EXPECT_NEAR(guard.force().x, 0.0, 1e-9);
}

}  // namespace
}  // namespace onggi
