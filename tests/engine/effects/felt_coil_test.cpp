// A coil as hands feel it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/effects/building_hands.h"

namespace onggi::effects::felt_coil_test {
namespace {

using namespace effects_test;

TEST(FeltCoil, AHandFeelsTheRimThroughItsCoil) {
  const SceneDef def = bench();
  Scene scene = made(def);
  Hands hands;
  const auto felt = [&](Vec3 at) {
    hands.hand[0] = {at, true};
    hands.hand[0].coil = true;
    Feedback back;
    for (int n = 0; n < 800; ++n) back = scene.step(hands, 0.001);
    return back.hand[0].force;
  };
  EXPECT_EQ(felt({0.02, 0.0175, 0}), Vec3{});
  const Vec3 light = felt({0.02, 0.0155, 0}), firm = felt({0.02, 0.0150, 0});
  EXPECT_GT(light.y, 0.05);
  EXPECT_GT(firm.y, 1.5 * light.y);
  EXPECT_NEAR(light.x, 0.0, 1e-9);
}

TEST(FeltCoil, AHandWithoutACoilFeelsTheOneThatLiesAndOnlyThere) {
  const SceneDef def = bench();
  Scene scene = made(def);
  go_round(scene, 0.035, 0.5);
  wait(scene, 0.1);
  const auto felt = [&](double angle) {
    Hands hands;
    hands.hand[0] = {{0.035 * portable::cos(angle), 0.030, 0.035 * portable::sin(angle)}, true};
    Feedback back;
    for (int n = 0; n < 800; ++n) back = scene.step(hands, 0.001);
    wait(scene, 0.1);
    return length(back.hand[0].force);
  };
  EXPECT_GT(felt(1.5), 0.1);
  EXPECT_EQ(felt(4.5), 0.0);
  // It passes over the end without a step: from one place to the next the force changes little.
  double most = 0.0, before = felt(2.9);
  for (double angle = 2.9; angle < 3.7; angle += 0.01) {
    const double now = felt(angle);
    most = std::max(most, std::fabs(now - before));
    before = now;
  }
  EXPECT_LT(most, 0.15);
}

// Sixteen sectors are 14 mm apart, more than the coil is thick.
TEST(FeltCoil, BetweenTwoRaysACoilIsAsHighAsOnThem) {
  const SceneDef def = bench(12, 16);
  Scene scene = made(def);
  go_round(scene, 0.035, 0.6);
  const double step = 2.0 * portable::kPi / 16;
  const auto felt = [&](double angle) {
    Hands hands;
    hands.hand[0] = {{0.0345 * portable::cos(angle), 0.030, 0.0345 * portable::sin(angle)}, true};
    Feedback back;
    for (int n = 0; n < 800; ++n) back = scene.step(hands, 0.001);
    wait(scene, 0.1);
    return back.hand[0].force.y;
  };
  const double on = felt(4.5 * step), between = felt(5.0 * step);
  EXPECT_GT(on, 0.08);
  EXPECT_NEAR(between, on, 0.2 * on);
}

}  // namespace
}  // namespace onggi::effects::felt_coil_test
