#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "engine/force/guard.h"

namespace onggi::force::force_test {
namespace {

constexpr GuardLimits kLimits{3.3, 600.0, 0.5};

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

TEST(Guard, AForceWhoseLengthOverflowsIsShortenedAndKeepsItsWay) {
  Guard guard;
  bool ok = true;
  for (int n = 0; n < 1000; ++n) guard.step({}, 0.001, kLimits, ok);
  for (const double size : {1e90, 1e170, 4e307}) {
    for (int n = 0; n < 20; ++n) guard.step({3.0 * size, -4.0 * size, 0.0}, 0.001, kLimits, ok);
    EXPECT_TRUE(ok);
    EXPECT_NEAR(guard.force().x, 0.6 * kLimits.max_force, 1e-9) << size;
    EXPECT_NEAR(guard.force().y, -0.8 * kLimits.max_force, 1e-9) << size;
  }
}

TEST(Guard, RampsAHandInOverTheEngageTime) {
  Guard guard;
  bool ok = true;
  guard.step({0, 0, 0}, 0.001, kLimits, ok);
  for (int n = 0; n < 249; ++n) guard.step({1, 0, 0}, 0.001, kLimits, ok);
  EXPECT_NEAR(guard.force().x, 0.499, 1e-9);  // the mean of that tick's 0.498 to 0.5
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
}  // namespace onggi::force::force_test
