#include "engine/lab/stiffness_limit.h"

#include <algorithm>
#include <cmath>

#include "engine/lab/sampled_theory.h"

namespace onggi::lab {

namespace {

constexpr HandModel kHands[] = {kFreeHand, kLightHand, kFirmHand};
constexpr double kPush = 0.5;   // N
constexpr double kLead = 2e-4;  // m: how far a hand that leads goes
constexpr int kHalvings = 12;

/// The largest of low..high for which `holds`, assumed to hold for all smaller ones.
template <class Holds>
double largest(double low, double high, Holds&& holds) {
  if (!holds(low)) return 0.0;
  if (holds(high)) return high;
  for (int n = 0; n < kHalvings; ++n) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// A loop of the coupling alone, deep enough in the wheel head to stay in it.
LoopPlan coupled(const DeviceModel& device, const HandModel& hand, double stiffness) {
  LoopPlan plan = on_the_wheel_head(device, hand, LoopWall::rendered);
  plan.coupling = stiffness;
  plan.passivity = false;
  return plan;
}

bool comes_to_rest(const DeviceModel& device, double stiffness) {
  // An encoder makes limit cycles of its own; they are tested apart.
  DeviceModel smooth = device;
  smooth.step = 0.0;
  return std::ranges::all_of(kHands, [&](const HandModel& hand) {
    LoopPlan plan = coupled(smooth, hand, stiffness);
    plan.seconds = 8.0;
    plan.kick = {0.0, -0.02, 0.0};
    const LoopResult result = run_loop(plan);
    return result.swing < 1e-6 || result.dies_away();
  });
}

/// Led to and fro about the place where half a newton holds it.
LoopPlan led(const DeviceModel& device, double stiffness) {
  LoopPlan plan = coupled(device, kFreeHand, stiffness);
  plan.device.step = 0.0;
  const double r = plan.scene.tool.radius;
  const double stop = std::sqrt(kPush / (plan.scene.contact.stiffness * 3.14159265358979 * r));
  plan.begins.y = r - std::max(2.0 * kLead, stop) - kPush / stiffness;
  return plan;
}

}  // namespace

double StiffnessLimit::margin() const {
  return allowed > 0.0 ? std::min(stable, passive) / allowed : 0.0;
}

SceneDef loop_scene() {
  SceneDef def;
  def.clay.rows = 96;
  def.clay.sectors = 96;
  def.clay.keep_undo = false;
  def.guard.max_force = 22.2;
  def.guard.max_slew = 1e5;
  def.guard.engage_time = 0.05;
  return def;
}

LoopPlan on_the_wheel_head(const DeviceModel& device, const HandModel& hand, LoopWall wall) {
  LoopPlan plan;
  plan.device = device;
  plan.hand = hand;
  plan.wall = wall;
  plan.scene = loop_scene();
  plan.push = {0.0, -kPush, 0.0};
  plan.seconds = 20.0;
  return plan;
}

std::vector<DeviceModel> device_list() {
  std::vector<DeviceModel> all;
  for (const double damping : {0.1, 0.5, 1.0})
    for (const double friction : {0.0, 0.26})
      for (int delay = 0; delay <= 3; ++delay) {
        DeviceModel device;
        device.damping = damping;
        device.friction = friction;
        device.delay = delay;
        all.push_back(device);
      }
  return all;
}

StiffnessLimit derive_stiffness_limit(const DeviceModel& device) {
  StiffnessLimit limit;
  limit.colgate = std::min(
      kStiffestCoupling, theory::stiffest_passive(SampledWall::spring, device, LoopPlan::kSeconds));
  limit.stable = largest(kSoftestCoupling, kStiffestCoupling,
                         [&](double k) { return comes_to_rest(device, k); });
  limit.passive = largest(kSoftestCoupling, kStiffestCoupling,
                          [&](double k) { return least_damping(led(device, k), kLead) >= 0.0; });
  // Along the push and across it at once.
  limit.quiet = device.step > 0.0 ? kQuietStep / (std::sqrt(2.0) * device.step) : kStiffestCoupling;
  limit.allowed = std::min({limit.stable / kLoopMargin, limit.passive / kLoopMargin,
                            limit.colgate / kLoopMargin, limit.quiet});
  if (!(limit.allowed > 0.0)) return limit;
  limit.at_margin = comes_to_rest(device, kLoopMargin * limit.allowed) &&
                    least_damping(led(device, kLoopMargin * limit.allowed), kLead) >= 0.0;
  for (const HandModel& hand : kHands) {
    LoopPlan plan = coupled(device, hand, limit.allowed);
    plan.passivity = true;
    const LoopResult result = run_loop(plan);
    limit.swing = std::max(limit.swing, result.swing);
    limit.force_step = std::max(limit.force_step, result.force_step);
  }
  return limit;
}

}  // namespace onggi::lab
