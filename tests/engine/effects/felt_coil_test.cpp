// A coil as hands feel it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/effects/building_hands.h"

namespace onggi::effects {
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

}  // namespace
}  // namespace onggi::effects
