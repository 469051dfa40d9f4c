#include <gtest/gtest.h>

#include <cmath>

#include "engine/lab/closed_loop.h"
#include "engine/lab/sampled_theory.h"
#include "engine/lab/stiffness_limit.h"

namespace onggi::lab::closed_loop_test {
namespace {

constexpr double kTick = LoopPlan::kSeconds;

DeviceModel device(double damping, int delay, double step = 0.0) {
  DeviceModel made;
  made.damping = damping;
  made.delay = delay;
  made.step = step;
  return made;
}

/// Softest and stiffest wall of a kind between which a loop begins to swing, N/m.
double found_stable(LoopWall wall, const DeviceModel& device, const HandModel& hand) {
  double low = 1.0, high = 1e5;
  LoopPlan plan;
  plan.device = device;
  plan.hand = hand;
  plan.wall = wall;
  plan.kick = {0.0, 0.05, 0.0};
  plan.seconds = 4.0;
  for (int n = 0; n < 14; ++n) {
    plan.stiffness = std::sqrt(low * high);
    const LoopResult result = run_loop(plan);
    (result.swing < result.before || result.swing < 1e-9 ? low : high) = plan.stiffness;
  }
  return low;
}

TEST(ClosedLoop, ASpringIsStableAsFarAsTheEigenvaluesOfTheSampledSystemSay) {
  for (const double damping : {0.1, 0.5, 1.0})
    for (const int delay : {0, 1, 3})
      for (const HandModel& hand : {kFreeHand, kLightHand}) {
        const DeviceModel d = device(damping, delay);
        const double theory = theory::stiffest_stable(SampledWall::spring, d, hand, kTick);
        const double found = found_stable(LoopWall::spring, d, hand);
        EXPECT_NEAR(found / theory, 1.0, 0.05) << damping << ' ' << delay << ' ' << theory;
      }
}

TEST(ClosedLoop, ASpringIsPassiveAsFarAsColgateSays) {
  for (const int delay : {0, 1, 2, 3}) {
    LoopPlan plan;
    plan.device = device(0.0, delay);
    plan.stiffness = 400.0;
    const double colgate = 400.0 * (0.5 + delay) * kTick;
    EXPECT_NEAR(-least_damping(plan, 2e-4) / colgate, 1.0, 0.05) << delay;
    EXPECT_NEAR(400.0 * theory::passive_damping(SampledWall::spring, delay, kTick) / colgate, 1.0,
                1e-3);
  }
}

TEST(ClosedLoop, MaxwellsClayIsStableAsFarAsTheEigenvaluesSay) {
  for (const int delay : {1, 3}) {
    const DeviceModel d = device(0.1, delay);
    const double theory = theory::stiffest_stable(SampledWall::maxwell, d, kFreeHand, kTick);
    EXPECT_NEAR(found_stable(LoopWall::maxwell, d, kFreeHand) / theory, 1.0, 0.05) << delay;
  }
}

TEST(ClosedLoop, ClayThatGivesWayTakesTheDampingThatTheoryAsks) {
  const double keeps = std::exp(-kTick / theory::kRelaxation);
  EXPECT_NEAR(theory::passive_damping(SampledWall::maxwell, 0, kTick) / (kTick / (1.0 + keeps)),
              1.0, 1e-3);
}

TEST(ClosedLoop, ThePapersFilterMakesASpringThirtyTimesSofterUnstable) {
  const DeviceModel d = device(0.5, 0);
  const double bare = theory::stiffest_stable(SampledWall::spring, d, kFreeHand, kTick);
  const double filtered =
      theory::stiffest_stable(SampledWall::filtered_spring, d, kFreeHand, kTick);
  EXPECT_NEAR(found_stable(LoopWall::filtered_spring, d, kFreeHand) / filtered, 1.0, 0.05);
  EXPECT_LT(filtered, bare / 30.0);
  LoopPlan plan = on_the_wheel_head(d, kFreeHand, LoopWall::filtered_engine);
  EXPECT_FALSE(run_loop(plan).at_rest()) << "and so the wheel head";
}

// What a device got before there was a coupling: 10 mm to and fro for ever.
TEST(ClosedLoop, AScenesOwnForceOnALightDeviceNeverComesToRestAndTheRenderedOneDoes) {
  DeviceModel light;
  light.damping = 0.1;
  LoopPlan plan = on_the_wheel_head(light, kFreeHand, LoopWall::engine);
  EXPECT_GT(run_loop(plan).swing, 2e-3);
  plan.wall = LoopWall::rendered;
  plan.coupling = derive_stiffness_limit(light).allowed;
  const LoopResult rendered = run_loop(plan);
  EXPECT_LT(rendered.swing, 1e-4);
  EXPECT_LT(rendered.force_step, 0.02);
  EXPECT_NEAR(rendered.force_mean, 0.5, 0.01) << "and it carries the hand all the same";
}

TEST(ClosedLoop, WhatEveryDeviceIsGivenIsStableAndPassiveWithAMarginInEveryHand) {
  for (const DeviceModel& d : device_list()) {
    // Friction only helps, and `onggi lab loop` looks at all of them.
    if (d.delay == 2 || (d.friction > 0.0 && (d.damping > 0.1 || d.delay < 3))) continue;
    const StiffnessLimit limit = derive_stiffness_limit(d);
    const auto who = [&] {
      return ::testing::Message() << d.damping << " N s/m, " << d.friction << " N, " << d.delay
                                  << " ticks: allowed " << limit.allowed << ", stable "
                                  << limit.stable << ", passive " << limit.passive;
    };
    EXPECT_TRUE(limit.at_margin) << who();
    EXPECT_GE(limit.margin(), kLoopMargin * 0.999) << who();
    EXPECT_LE(limit.allowed, limit.colgate / kLoopMargin * 1.001) << who();
    EXPECT_LT(limit.swing, 1e-4) << who();
    EXPECT_LT(limit.force_step, 0.02) << who();
    // No softer than it must be: half as much again breaks a limit, or the encoder's step is felt.
    const double more = 1.501 * limit.allowed;
    EXPECT_TRUE(more > limit.colgate || more > limit.stable || more > limit.passive ||
                more > limit.quiet)
        << who();
  }
}

TEST(ClosedLoop, AToolHeldInAWallThatTurnsDoesNotHopOnItsOwnMarks) {
  // A ball held in the side of a turning lump by each hand, on a light and on a heavy device: 3 mm
  // deep, and 6 mm at 300 rpm, where its groove takes 8 s to come round without a seam, and of 19
  // N/m 24.
  struct Held {
    double deep, wheel, seconds;
  };
  for (const Held held : {Held{0.003, 10.0, 6.0}, Held{0.006, 31.4, 12.0}})
    for (const DeviceModel& d : {device(0.1, 3, 5.5e-5), device(1.0, 0, 5.5e-5)})
      for (const HandModel& hand : {kLightHand, kFirmHand}) {
        LoopPlan plan = on_the_wheel_head(d, hand, LoopWall::rendered);
        plan.coupling = d.delay == 3 ? 19.0 : 257.0;
        // The loop's own scene is coarse, for speed: its elements are four times those of a scene
        // that is played, and shake a tool sixteen times as much.
        plan.scene.clay.rows = 400;
        plan.scene.clay.sectors = 360;
        plan.begins = {plan.scene.clay.outer_radius + plan.scene.tool.radius, 0.06, 0.0};
        plan.rest = plan.begins - Vec3{held.deep, 0.0, 0.0};
        plan.push = {};
        plan.wheel = held.wheel;
        plan.seconds = d.delay == 3 && held.deep > 0.005 ? 32.0 : held.seconds;
        const LoopResult result = run_loop(plan);
        EXPECT_TRUE(result.at_rest()) << d.damping << ' ' << result.swing;
        EXPECT_LT(result.force_step, 0.02) << d.damping;
      }
}

}  // namespace
}  // namespace onggi::lab::closed_loop_test
