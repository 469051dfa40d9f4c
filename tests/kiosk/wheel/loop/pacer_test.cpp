#include "kiosk/wheel/loop/pacer.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace onggi::loop::pacer_test {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(Pacer, PunctualWakesMakeTicksOfOneMillisecond) {
  Pacer pacer;
  pacer.begin(0);
  for (int i = 1; i <= 1000; ++i) {
    EXPECT_EQ(pacer.wake_at(), i * kMs);
    EXPECT_DOUBLE_EQ(pacer.wake(i * kMs + 20'000), 1e-3);
    pacer.done(i * kMs + 40'000);
  }
  EXPECT_EQ(pacer.deadlines().overruns, 0u);
  EXPECT_EQ(pacer.deadlines().lost_ticks, 0u);
}

TEST(Pacer, SeveralMissedTicksInARowAreAStrainAndOnePunctualWakeEndsIt) {
  Pacer pacer;
  pacer.begin(0);
  const auto wake = [&pacer](std::int64_t late) {
    const std::int64_t now = pacer.wake_at() + late;
    pacer.wake(now);
    pacer.done(now + 1000);
    return pacer.strained();
  };
  EXPECT_FALSE(wake(2 * kMs));
  EXPECT_FALSE(wake(2 * kMs));
  EXPECT_TRUE(wake(2 * kMs));
  EXPECT_TRUE(wake(kMs));
  EXPECT_FALSE(wake(20'000));
  EXPECT_EQ(pacer.deadlines().overruns, 4u);
  EXPECT_DOUBLE_EQ(pacer.wake_us(), 20.0);
  EXPECT_DOUBLE_EQ(pacer.tick_us(), 1.0);
}

TEST(Pacer, AStandstillIsPaidBackInLongerTicksAndNothingIsLost) {
  Pacer pacer;
  pacer.begin(0);
  double clay_time = pacer.wake(kMs);
  pacer.done(kMs + 1000);
  std::int64_t now = 101 * kMs;  // 100 ms late.
  for (int i = 0; i < 200; ++i) {
    const double dt = pacer.wake(now);
    EXPECT_GE(dt, 1e-3);
    EXPECT_LE(dt, 5e-3);
    clay_time += dt;
    pacer.done(now + 1000);
    now = pacer.wake_at();
  }
  const double wall = static_cast<double>(now - kMs) * 1e-9;
  EXPECT_NEAR(clay_time, wall, 1.5e-3);
  EXPECT_EQ(pacer.deadlines().lost_ticks, 0u);
  EXPECT_EQ(pacer.deadlines().overruns, 1u);
}

TEST(Pacer, OnlyAStandstillOfOverAQuarterSecondIsGivenUpAndCounted) {
  Pacer pacer;
  pacer.begin(0);
  pacer.wake(2'000 * kMs);
  EXPECT_NEAR(static_cast<double>(pacer.deadlines().lost_ticks), 1750.0, 1.0);
}

TEST(Pacer, WakesAreAlwaysInTheFutureAndOnTheGrid) {
  EXPECT_TRUE(rc::check([] {
    Pacer pacer;
    pacer.begin(0);
    std::int64_t now = 0;
    const auto n = *rc::gen::inRange(1, 200);
    for (int i = 0; i < n; ++i) {
      now = std::max(now, pacer.wake_at()) + *rc::gen::inRange<std::int64_t>(0, 12 * kMs);
      const double dt = pacer.wake(now);
      RC_ASSERT(std::abs(dt * 1000 - std::round(dt * 1000)) < 1e-9);
      now += *rc::gen::inRange<std::int64_t>(0, 3 * kMs);
      pacer.done(now);
      RC_ASSERT(pacer.wake_at() > now);
      RC_ASSERT(pacer.wake_at() % kMs == 0);
    }
  }));
}

}  // namespace
}  // namespace onggi::loop::pacer_test
