#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/lab/closed_loop.h"
#include "engine/lab/stiffness_limit.h"

// A decorating tool in the loop of device, hand, wire and leather-hard clay.

namespace onggi::lab::leather_loop_test {
namespace {

using force::DecoratingLaw;
using force::DecoratingTool;

/// The usual tools, and of each kind the one with the stiffest wall.
const std::vector<DecoratingTool>& tools() {
  static const std::vector<DecoratingTool> all{
      {DecoratingLaw::cut, 1e-3, 5e-4, 0.0, 0.5}, {DecoratingLaw::cut, 0.008, 7e-4, 0.0},
      {DecoratingLaw::cut, 0.04, 0.003, 1.0},     {DecoratingLaw::scrape, 0.04, 1.5e-4, 1.0},
      {DecoratingLaw::brush, 0.008, 0.003},       {DecoratingLaw::brush, 0.04, 1.5e-4},
      {DecoratingLaw::wipe, 0.04, 1.5e-4},        {DecoratingLaw::stamp, 0.04, 1.5e-4, 1.0}};
  return all;
}

LoopPlan pressed(const DeviceModel& device, const HandModel& hand, const DecoratingTool& tool,
                 double coupling) {
  LoopPlan plan = on_the_wheel_head(device, hand, LoopWall::leather);
  plan.tool = tool;
  plan.coupling = coupling;
  plan.begins = plan.rest = {0.12, 2e-4, 0.0};
  plan.push = {0.0, -0.4, 0.0};
  return plan;
}

TEST(LeatherLoop, WhatADeviceIsGivenAtTheWheelIsStableHereWithTheSameMargin) {
  for (const DeviceModel& d : device_list()) {
    if (d.friction > 0.0 || d.delay == 2) continue;  // friction only helps
    const double given = derive_stiffness_limit(d).allowed;
    for (const DecoratingTool& tool : tools())
      for (const HandModel& hand : {kFreeHand, kLightHand, kFirmHand}) {
        DeviceModel smooth = d;
        smooth.step = 0.0;  // An encoder makes limit cycles of its own.
        for (const double margin : {1.0, kLoopMargin}) {
          LoopPlan plan = pressed(smooth, hand, tool, margin * given);
          plan.passivity = false;
          plan.seconds = 8.0;
          // Along the wall a tool that is held is the coupling alone, and at the margin that has by
          // its own definition no damping left.
          plan.kick = {margin > 1.0 ? 0.0 : 0.01, -0.02, 0.0};
          const LoopResult result = run_loop(plan);
          EXPECT_TRUE(result.swing < 1e-6 || result.dies_away())
              << margin << ": " << d.damping << " N s/m, " << d.delay << " ticks, law "
              << static_cast<int>(tool.law) << ", " << tool.width << " m, hand " << hand.stiffness
              << ", " << result.swing << " m, before " << result.before;
        }
      }
  }
}

TEST(LeatherLoop, WithAnEncoderItRestsAndItsForceDoesNotBuzz) {
  for (const DeviceModel& d : device_list()) {
    if (d.friction > 0.0 || d.delay == 2) continue;
    const double given = derive_stiffness_limit(d).allowed;
    for (const DecoratingTool& tool : tools())
      for (const HandModel& hand : {kFreeHand, kLightHand, kFirmHand}) {
        const LoopResult result = run_loop(pressed(d, hand, tool, given));
        EXPECT_TRUE(result.at_rest()) << d.damping << ' ' << d.delay << ' ' << result.swing;
        EXPECT_LT(result.force_step, 0.02) << d.damping << ' ' << d.delay;
      }
  }
}

TEST(LeatherLoop, AHandThatLeadsItPutsEnergyInAtEveryFrequencyWithTheMargin) {
  for (const DeviceModel& d : device_list()) {
    if (d.friction > 0.0 || d.delay == 2) continue;
    const double given = derive_stiffness_limit(d).allowed;
    for (const DecoratingTool& tool : tools()) {
      LoopPlan plan = pressed(d, kFreeHand, tool, kLoopMargin * given);
      plan.device.step = 0.0;
      plan.passivity = false;
      plan.begins.y = -4e-4;  // it stays in the clay
      EXPECT_GE(least_damping(plan, 2e-4), 0.0)
          << d.damping << " N s/m, " << d.delay << " ticks, law " << static_cast<int>(tool.law);
    }
  }
}

TEST(LeatherLoop, ACouplingThatADeviceDoesNotBearSwings) {
  // Else the tests above could not fail.
  DeviceModel light;
  light.damping = 0.1;
  light.delay = 3;
  light.step = 0.0;
  LoopPlan plan = pressed(light, kFreeHand, tools()[1], 300.0);
  plan.passivity = false;
  plan.seconds = 8.0;
  EXPECT_FALSE(run_loop(plan).at_rest());
}

}  // namespace
}  // namespace onggi::lab::leather_loop_test
