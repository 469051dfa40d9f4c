// A paddle in the loop of device, hand, wire and a wall that is firm for it.
#include <gtest/gtest.h>

#include <vector>

#include "engine/lab/closed_loop.h"
#include "engine/lab/stiffness_limit.h"

namespace onggi::lab::paddle_loop_test {
namespace {

/// A hand leans a paddle on the outside of a wall by 0.4 N, on the first ray.
LoopPlan leaned(const DeviceModel& device, const HandModel& hand, double coupling) {
  LoopPlan plan = on_the_wheel_head(device, hand, LoopWall::rendered);
  plan.scene.volume.emplace();
  plan.scene.beating.emplace();
  plan.paddle = true;
  plan.coupling = coupling;
  const ClayDef& clay = plan.scene.clay;
  plan.begins = plan.rest = {clay.outer_radius + plan.scene.tool.radius, 0.5 * clay.height, 0.0};
  plan.push = {-0.4, 0.0, 0.0};
  plan.lead = {1.0, 0.0, 0.0};
  return plan;
}

struct Given {
  DeviceModel device;
  double coupling = 0.0;  // N/m
};
/// The least and the best of the devices without friction, which only helps, and what they get.
const std::vector<Given>& devices() {
  static const std::vector<Given> all = [] {
    std::vector<Given> some;
    for (const DeviceModel& d : device_list())
      if (d.friction == 0.0 && d.delay % 3 == 0 && d.damping != 0.5)
        some.push_back({d, derive_stiffness_limit(d).allowed});
    return some;
  }();
  return all;
}

TEST(PaddleLoop, OnTheWallItIsStableWithTheMarginThatTheWheelHeadGives) {
  for (const auto& [d, given] : devices())
    for (const HandModel& hand : {kFreeHand, kLightHand, kFirmHand})
      for (const double margin : {1.0, kLoopMargin}) {
        LoopPlan plan = leaned(d, hand, margin * given);
        plan.device.step = 0.0;  // An encoder makes limit cycles of its own.
        plan.passivity = false;
        plan.seconds = 8.0;
        plan.kick = {-0.02, 0.0, 0.0};
        const LoopResult result = run_loop(plan);
        EXPECT_TRUE(result.swing < 1e-6 || result.dies_away())
            << margin << ": " << d.damping << " N s/m, " << d.delay << " ticks, hand "
            << hand.stiffness << ", " << result.swing << " m, before " << result.before;
      }
}

TEST(PaddleLoop, AHandThatLeadsItPutsEnergyInAtEveryFrequencyWithTheMargin) {
  for (const auto& [d, given] : devices()) {
    LoopPlan plan = leaned(d, kFreeHand, kLoopMargin * given);
    plan.device.step = 0.0;
    plan.passivity = false;
    plan.begins.x -= 6e-4;  // it stays on the wall
    EXPECT_GE(least_damping(plan, 2e-4), 0.0) << d.damping << " N s/m, " << d.delay << " ticks";
  }
}

TEST(PaddleLoop, WithAnEncoderAndASlowWheelItRestsAndItsForceDoesNotBuzz) {
  for (const auto& [d, given] : devices())
    for (const HandModel& hand : {kFreeHand, kLightHand, kFirmHand}) {
      LoopPlan plan = leaned(d, hand, given);
      plan.wheel = 2.0;
      const LoopResult result = run_loop(plan);
      EXPECT_TRUE(result.at_rest()) << d.damping << ' ' << d.delay << ' ' << result.swing;
      EXPECT_LT(result.force_step, 0.02) << d.damping << ' ' << d.delay;
      if (hand.stiffness == 0.0) {
        EXPECT_NEAR(result.force_mean, 0.4, 0.02) << "it is on the wall";
      }
    }
}

// Three blows a second throw a handle that no hand holds; whoever holds it keeps the paddle.
TEST(PaddleLoop, BlowsThrowNoHandle) {
  for (const auto& [d, given] : devices())
    for (const HandModel& hand : {kLightHand, kFirmHand}) {
      LoopPlan plan = leaned(d, hand, given);
      plan.beats = 0.34;
      plan.wheel = 2.0;
      const LoopResult result = run_loop(plan);
      EXPECT_LT(result.swing, 0.01) << d.damping << ' ' << d.delay << ", hand " << hand.stiffness;
      EXPECT_GT(result.swing, 1e-4) << "the blows are felt";
    }
}

TEST(PaddleLoop, ACouplingThatADeviceDoesNotBearSwings) {
  // Else the tests above could not fail.
  DeviceModel light;
  light.damping = 0.1;
  light.delay = 3;
  light.step = 0.0;
  LoopPlan plan = leaned(light, kFreeHand, 300.0);
  plan.passivity = false;
  plan.seconds = 8.0;
  EXPECT_FALSE(run_loop(plan).at_rest());
}

}  // namespace
}  // namespace onggi::lab::paddle_loop_test
