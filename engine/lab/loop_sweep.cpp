#include "engine/lab/loop_sweep.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/lab/sampled_theory.h"
#include "engine/math/portable.h"

namespace onggi::lab {

namespace {

constexpr double kHalfNewton = 0.5;
constexpr double kLedWay = 2e-4;  // m
constexpr int kSteps = 12;        // of a bisection: to 0.3 % of a decade
constexpr double kSoftest = 1.0;  // N/m
// N/m a m^2 of wall. In softer clay a ball sinks right in; no scene's clay is stiffer.
constexpr double kSoftestClay = 1e6, kStiffestClay = 5e7;

std::optional<SampledWall> theory_of(LoopWall wall) {
  switch (wall) {
    case LoopWall::spring:
      return SampledWall::spring;
    case LoopWall::maxwell:
      return SampledWall::maxwell;
    case LoopWall::filtered_spring:
      return SampledWall::filtered_spring;
    case LoopWall::engine:
    case LoopWall::filtered_engine:
    case LoopWall::rendered:
    case LoopWall::leather:
      break;
  }
  return std::nullopt;
}

bool engines(LoopWall wall) {
  return wall == LoopWall::engine || wall == LoopWall::filtered_engine;
}

/// The stiffness of the wheel head where it carries half a newton: F = k pi r d^2.
double head_stiffness(const SceneDef& scene) {
  return 2.0 * std::sqrt(kHalfNewton * scene.contact.stiffness * portable::kPi * scene.tool.radius);
}

/// A plan for a wall of `stiffness` N/m of any kind.
LoopPlan of_stiffness(LoopPlan plan, double stiffness) {
  plan.stiffness = plan.coupling = stiffness;
  if (engines(plan.wall))
    plan.scene.contact.stiffness =
        stiffness * stiffness / (4.0 * kHalfNewton * portable::kPi * plan.scene.tool.radius);
  return plan;
}

/// For the sweep: no encoder (it makes limit cycles of its own) and no passivity controller.
LoopPlan swept(const DeviceModel& device, const HandModel& hand, LoopWall wall) {
  LoopPlan plan = on_the_wheel_head(device, hand, wall);
  plan.device.step = 0.0;
  plan.passivity = false;
  plan.seconds = 8.0;
  plan.kick = {0.0, theory_of(wall) ? 0.05 : -0.02, 0.0};
  if (theory_of(wall)) plan.push = {};
  return plan;
}

bool comes_to_rest_at(const LoopPlan& plan, double stiffness) {
  const LoopResult result = run_loop(of_stiffness(plan, stiffness));
  return result.swing < 1e-6 || result.dies_away();
}

bool passive_at(const LoopPlan& plan, double stiffness) {
  LoopPlan led = of_stiffness(plan, stiffness);
  led.kick = led.push = {};
  if (!theory_of(plan.wall)) {
    const double head = head_stiffness(led.scene);
    led.begins.y = led.scene.tool.radius - std::max(2.0 * kLedWay, 2.0 * kHalfNewton / head);
    if (plan.wall == LoopWall::rendered) led.begins.y -= kHalfNewton / stiffness;
  }
  return least_damping(led, kLedWay) >= 0.0;
}

template <class Holds>
double stiffest(double low, double high, Holds&& holds) {
  if (!holds(low)) return 0.0;
  if (holds(high)) return kStiffestCoupling;
  for (int n = 0; n < kSteps; ++n) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double LoopRow::margin() const { return given > 0.0 ? std::min(stable, passive) / given : 0.0; }

std::vector<LoopRow> sweep_device(const DeviceModel& device, const StiffnessLimit& limit) {
  std::vector<LoopRow> rows;
  const SceneDef scene = loop_scene();
  for (const LoopWall wall : {LoopWall::spring, LoopWall::maxwell, LoopWall::filtered_spring,
                              LoopWall::engine, LoopWall::filtered_engine, LoopWall::rendered}) {
    const auto theory = theory_of(wall);
    SceneDef softest = scene, hardest = scene;
    softest.contact.stiffness = kSoftestClay;
    hardest.contact.stiffness = 0.999 * kStiffestClay;
    const double low = engines(wall) ? head_stiffness(softest) : kSoftest;
    const double high = engines(wall) ? head_stiffness(hardest) : kStiffestCoupling;
    double passive = -1.0;
    for (const NamedHand& named : kLoopHands) {
      const LoopPlan plan = swept(device, named.hand, wall);
      LoopRow row;
      row.device = device;
      row.hand = named.name;
      row.wall = wall;
      row.given = wall == LoopWall::rendered ? limit.allowed : head_stiffness(scene);
      row.stable = stiffest(low, high, [&](double k) { return comes_to_rest_at(plan, k); });
      // Where the handle is led, the leading hand is the only one.
      if (passive < 0.0)
        passive = stiffest(low, high, [&](double k) { return passive_at(plan, k); });
      row.passive = passive;
      if (theory) {
        row.eigenvalues = theory::stiffest_stable(*theory, device, named.hand, LoopPlan::kSeconds);
        row.colgate = theory::stiffest_passive(*theory, device, LoopPlan::kSeconds);
      } else if (wall == LoopWall::rendered) {
        row.colgate = limit.colgate;
      }
      LoopPlan ships = of_stiffness(on_the_wheel_head(device, named.hand, wall), row.given);
      if (theory) ships.kick = {0.0, 0.05, 0.0};
      const LoopResult result = run_loop(ships);
      row.rests = result.at_rest();
      row.swing = result.swing;
      row.force_step = result.force_step;
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<SceneLoop> try_scene(const SceneDef& scene, const DeviceModel& device,
                                 double coupling) {
  std::vector<SceneLoop> all;
  for (const NamedHand& named : kLoopHands)
    for (const bool turning : {false, true}) {
      if (!turning && scene.paper) continue;  // The printed model has no wheel head.
      LoopPlan plan = on_the_wheel_head(device, named.hand, LoopWall::rendered);
      const SceneDef usual = plan.scene;
      plan.scene = scene;
      plan.scene.clay.rows = usual.clay.rows;
      plan.scene.clay.sectors = usual.clay.sectors;
      plan.coupling = coupling;
      plan.seconds = 30.0;
      if (turning) {
        // Under half a newton no hand sinks through the wall; it only passes by.
        plan.wheel = 10.0;
        plan.seconds = 6.0;
        plan.begins = {scene.clay.outer_radius + scene.tool.radius, 0.5 * scene.clay.height, 0.0};
        plan.rest = plan.begins - Vec3{0.003, 0.0, 0.0};
        plan.push = {};
        if (named.hand.stiffness <= 0.0) plan.kick = {-0.05, 0.0, 0.0};
      }
      const LoopResult result = run_loop(plan);
      all.push_back({named.name, turning, result.at_rest(), result.swing, result.force_step});
    }
  return all;
}

}  // namespace onggi::lab
