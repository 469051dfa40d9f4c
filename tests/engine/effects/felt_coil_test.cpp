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

TEST(FeltCoil, AHandWhoseCoilRestsOnTheRimIsInContactWithTheClay) {
  Scene scene = made(bench());
  Hands hands;
  hands.hand[0] = {{0.02, resting(scene), 0}, true};
  hands.hand[0].coil = true;
  EXPECT_TRUE(scene.step(hands, 0.001).hand[0].contact);
  hands.hand[0].position.y += 0.002;
  EXPECT_FALSE(scene.step(hands, 0.001).hand[0].contact) << "above the rim";
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

// The coil in the hand is what rises: the hand is not caught by it.
TEST(FeltCoil, AHandThatHoldsStillWhileItsRingClosesIsNeitherPulledNorPushed) {
  for (const int rows : {12, 400}) {
    const SceneDef def = bench(rows, rows == 12 ? 64 : 360);
    Scene scene = made(def);
    Hands hands;
    hands.wheel_speed = 5.0;
    hands.hand[0] = {{0.035, resting(scene) - 0.001, 0.0}, true};
    hands.hand[0].coil = true;
    Vec3 before;
    double most = 0.0;
    bool closed = false;
    for (int n = 0; n < 2500; ++n) {
      const Vec3 now = scene.step(hands, 0.001).hand[0].force;
      if (n > 600) most = std::max(most, length(now - before));
      EXPECT_GE(now.y, -1e-9) << n;
      before = now;
      closed = closed || scene.coil().added > 0.0;
    }
    EXPECT_TRUE(closed);
    EXPECT_EQ(length(before), 0.0) << "what is left of the coil is used up";
    EXPECT_LE(most, 0.6 + 1e-9);  // the guard's slew
    EXPECT_TRUE(scene.coil().centre.empty());
    // Lifted and brought down again, it has another coil.
    hands.hand[0].position.y = resting(scene) + 0.02;
    wait(scene, 0.2, hands);
    hands.hand[0].position.y = resting(scene) - 0.001;
    for (int n = 0; n < 300; ++n) scene.step(hands, 0.001);
    EXPECT_FALSE(scene.coil().centre.empty());
  }
}

// The wheel has turned by about a radian, and the coil with it.
TEST(FeltCoil, ACoilIsFeltWhereItIsNowAndPushesOutwardsFromThere) {
  const SceneDef def = bench();
  Scene scene = made(def);
  go_round(scene, 0.035, 0.5);  // from angle 0 to pi
  Hands turn;
  turn.wheel_speed = 5.0;
  double angle = 0.0;
  while (angle < 1.0) angle = scene.step(turn, 0.001).wheel_angle;
  Feedback back = scene.step({}, 0.001);
  while (back.wheel_speed > 0.0) back = scene.step({}, 0.001);
  const auto felt = [&](double at, double out) {
    Hands hands;
    Feedback now;
    for (int n = 0; n < 1200; ++n) {  // it comes down from above
      const double height = 0.027 + std::max(0.0, 0.02 - 0.00002 * n);
      hands.hand[0] = {{out * portable::cos(at), height, out * portable::sin(at)}, true};
      now = scene.step(hands, 0.001);
    }
    wait(scene, 0.1);
    return now.hand[0].force;
  };
  const double middle = 0.5 * portable::kPi + back.wheel_angle;
  EXPECT_EQ(felt(middle + portable::kPi, 0.041), Vec3{});
  for (const double off : {-0.6, 0.0, 0.6}) {
    const double at = middle + off;
    const Vec3 force = felt(at, 0.041);
    const double outwards = force.x * portable::cos(at) + force.z * portable::sin(at);
    const double along = force.z * portable::cos(at) - force.x * portable::sin(at);
    EXPECT_GT(outwards, 0.05) << off;
    EXPECT_LT(std::fabs(along), 0.1 * outwards) << off;
    EXPECT_GT(force.y, 0.05) << off;
  }
}

TEST(FeltCoil, APotThatIsCutFreeHasNothingToFeel) {
  const SceneDef def = bench();
  Scene scene = made(def);
  go_round(scene, 0.035, 0.5);
  Hands hands;
  hands.hand[0].active = true;
  for (std::uint8_t k = 0; k < def.tools.size(); ++k)
    if (def.tools[k].name == "wire") hands.hand[0].tool = k + 1;
  Feedback back;
  for (int n = 0; n < 3000 && back.cut_free < 1.0; ++n) {
    hands.hand[0].position = {0.08 - 0.00006 * n, 0.005, 0.0};
    back = scene.step(hands, 0.001);
  }
  ASSERT_EQ(back.cut_free, 1.0);
  wait(scene, 0.1);
  hands = {};
  hands.hand[0] = {{0.0, 0.030, 0.035}, true};
  for (int n = 0; n < 500; ++n) back = scene.step(hands, 0.001);
  EXPECT_EQ(length(back.hand[0].force), 0.0);
}

}  // namespace
}  // namespace onggi::effects::felt_coil_test
