#include "engine/force/blow_pulse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/random.h"

namespace onggi::force::blow_pulse_test {
namespace {

constexpr Vec3 kOut{1.0, 0.0, 0.0};

TEST(BlowPulse, IsStrongestInItsMiddleAndHasEnded) {
  BlowPulse pulse;
  pulse.begin(BlowPulse::kHalf, kOut);
  double most = 0.0, ends = 0.0;
  for (int n = 1; n <= 100; ++n) {
    const Vec3 push = pulse.step({}, 0.001);
    if (push.x > most) most = push.x;
    if (push.x > 0.0) ends = 0.001 * n;
    if (n == 12) {
      EXPECT_NEAR(push.x, 0.5 * BlowPulse::kMost, 0.05);
    }
  }
  EXPECT_NEAR(most, 0.5 * BlowPulse::kMost, 0.05);
  EXPECT_NEAR(ends, BlowPulse::kSeconds, 0.0015);
  EXPECT_FALSE(pulse.any());
}

TEST(BlowPulse, IsNoneForABlowThatMissed) {
  BlowPulse pulse;
  pulse.begin(0.0, kOut);
  EXPECT_FALSE(pulse.any());
  EXPECT_EQ(pulse.step({}, 0.001).x, 0.0);
}

// Whatever the hand does, it gains no more than one tick's work.
TEST(BlowPulse, GivesNoHandMoreThanItTook) {
  Random random(7);
  double worst = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    BlowPulse pulse;
    pulse.begin(random.uniform(1.0, 2000.0), kOut);
    const double tick = random.uniform(2e-4, 5e-3);
    double velocity = random.uniform(-1.0, 1.0);  // m/s
    double given = 0.0, fastest = 0.0;
    Vec3 push;
    for (int n = 0; n < 200; ++n) {
      velocity = std::clamp(velocity + random.uniform(-0.3, 0.3), -1.0, 1.0);
      fastest = std::max(fastest, std::fabs(velocity));
      given += push.x * velocity * tick;
      push = pulse.step({velocity * tick, 0.0, 0.0}, tick);
    }
    EXPECT_LE(given, BlowPulse::kMost * fastest * tick);
    worst = std::max(worst, given);
  }
  EXPECT_GT(worst, 0.0);  // hands that were thrown back were among them
}

// A mass (kg) that is swung against the wall comes back slower than it came.
TEST(BlowPulse, ThrowsNoHandBackFasterThanItCame) {
  for (const double mass : {0.05, 0.1, 0.3, 1.0})
    for (const double speed : {0.02, 0.1, 0.5, 1.0}) {
      BlowPulse pulse;
      pulse.begin(200.0, kOut);
      double velocity = -speed, way = 0.0;
      for (int n = 0; n < 300; ++n) {
        velocity += pulse.step({way, 0.0, 0.0}, 0.001).x / mass * 0.001;
        way = velocity * 0.001;
      }
      const double tick = std::sqrt(2.0 * BlowPulse::kMost * 0.001 * speed / mass);
      EXPECT_LT(velocity, speed + tick) << mass << " kg at " << speed;
    }
}

}  // namespace
}  // namespace onggi::force::blow_pulse_test
