#include "engine/force/hand_velocity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/random.h"

namespace onggi::force::hand_velocity_test {
namespace {

constexpr double kCount = 5.5e-5;  // m: the PHANToM Omni's encoder

double told(double x) { return kCount * std::floor(x / kCount + 0.5); }
Vec3 told(Vec3 p) { return {told(p.x), told(p.y), told(p.z)}; }

TEST(HandVelocity, OfAStillHandThatTremblesByHalfACountIsNothing) {
  Random random(3);
  for (const double dt : {0.0005, 0.001, 0.0023}) {
    HandVelocity hand;
    const Vec3 at{0.061, 0.1, 0.02};
    for (int n = 0; n < 4000; ++n) {
      const auto half = [&] { return (random.uniform() < 0.5 ? -0.5 : 0.5) * kCount; };
      const Vec3 v = hand.go(at + Vec3{half(), half(), half()}, dt);
      if (n < 100) continue;  // until the anchor stands in the middle
      ASSERT_EQ(length(v), 0.0) << n;
    }
  }
}

TEST(HandVelocity, OfAnEvenWayIsExactAtAnyTick) {
  for (const double dt : {1e-5, 0.0003, 0.001, 0.005})
    for (const double speed : {0.003, 0.03, 0.3, 3.0}) {
      HandVelocity hand;
      const Vec3 way{0.6 * speed, -0.8 * speed, 0.0};
      Vec3 v;
      for (double t = 0.0; t < 0.1; t += dt) v = hand.go(t * way, dt);
      EXPECT_NEAR(length(v - way), 0.0, 1e-9 * speed) << dt << ' ' << speed;
    }
}

TEST(HandVelocity, OfASlowHandIsToldOverTwoCountsAndNotFromTickToTick) {
  // 25 mm/s is a count in 2.2 ms: from tick to tick it would be nothing, or 55 mm/s.
  HandVelocity hand;
  for (int n = 0; n < 400; ++n) {
    const double v = hand.go({told(2.5e-5 * n), 0.0, 0.0}, 0.001).x;
    if (n < 20) continue;
    EXPECT_GT(v, 0.013) << n;
    EXPECT_LT(v, 0.038) << n;
  }
}

TEST(HandVelocity, OfOneThatSetsOutIsThereWithinTwoMilliseconds) {
  // Friction is felt by nine tenths from twice the slip speed on: 20 mm/s.
  for (const double speed : {0.1, 0.2, 0.5}) {
    HandVelocity hand;
    for (int n = 0; n < 100; ++n) hand.go({0.06, 0.1, told(0.5 * kCount * (n % 2))}, 0.0005);
    int late = 0;
    while (length(hand.go({0.06, 0.1, told(speed * 0.0005 * (late + 1))}, 0.0005)) < 0.02) ++late;
    EXPECT_LT(0.0005 * (late + 1), 0.002) << speed;
  }
}

TEST(HandVelocity, OfAStrokeToAndFroIsLateByLessThanTwoMilliseconds) {
  constexpr double kTurn = 2.0 * 3.14159265358979;
  for (const double dt : {0.0005, 0.001, 0.002})
    for (const bool counts : {false, true}) {
      const double pace = 3.0 * kTurn;  // three times a second, 25 mm either way
      HandVelocity hand;
      double with_sine = 0.0;
      double with_cosine = 0.0;
      for (int n = 0; n < static_cast<int>(2.0 / dt); ++n) {
        const double t = dt * n;
        const Vec3 at{0.025 * std::sin(pace * t), 0.0, 0.0};
        const double v = hand.go(counts ? told(at) : at, dt).x;
        if (t < 1.0) continue;
        with_sine += v * std::sin(pace * t);
        with_cosine += v * std::cos(pace * t);
      }
      const double late = std::atan2(with_sine, with_cosine) / pace;
      EXPECT_LT(late, 0.002) << dt << ' ' << counts;
      EXPECT_GT(late, 0.0) << dt << ' ' << counts;
    }
}

TEST(HandVelocity, IsNothingWhereAHandArrives) {
  HandVelocity hand;
  hand.go({0, 0, 0}, 0.001);
  EXPECT_GT(length(hand.go({0.001, 0, 0}, 0.001)), 0.9);
  hand.release();
  EXPECT_EQ(length(hand.go({0.5, 0, 0}, 0.001)), 0.0);
  EXPECT_EQ(length(hand.go({0.5, 0, 0}, 0.001)), 0.0);
}

}  // namespace
}  // namespace onggi::force::hand_velocity_test
