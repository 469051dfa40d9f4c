#pragma once

#include <vector>

#include "engine/lab/closed_loop.h"

namespace onggi::lab {

/// How stiff a coupling a device bears, and what limits it. N/m.
struct StiffnessLimit {
  double stable = 0.0;   ///< Up to here it comes to rest on the wheel head, in every hand.
  double passive = 0.0;  ///< Up to here it gives back no more energy than it took.
  double colgate = 0.0;  ///< Colgate's figure for `passive`: b / (T / 2 + delay T).
  double quiet = 0.0;    ///< Up to here an encoder step makes at most kQuietStep.
  double allowed = 0.0;  ///< The least of the first three over kMargin, and no more than `quiet`.
  double swing = 0.0;    ///< At `allowed`: half of the remaining motion on the wheel head, m, and
  double force_step = 0.0;  ///< the force's largest step, N; the worst of all hands.
  bool at_margin = false;   ///< At kMargin times `allowed` the whole loop is stable and passive.

  double margin() const;  ///< The lesser of `stable` and `passive`, over `allowed`.
};

inline constexpr double kLoopMargin = 1.5;        ///< Beyond what a device is given.
inline constexpr double kQuietStep = 0.02;        ///< N
inline constexpr double kStiffestCoupling = 1e5;  ///< N/m
inline constexpr double kSoftestCoupling = 5.0;   ///< N/m: the least that counts as a force device

/// Derives the limit by running loops of the real engine: a ball pressed on the wheel head by 0.5
/// N, the stiffest contact, and led to and fro in it, with the passivity controller off. No file,
/// no clock: the same figures everywhere. Some seconds; allocates.
StiffnessLimit derive_stiffness_limit(const DeviceModel& device);

/// The scene for this: all defaults, on a small grid.
SceneDef loop_scene();
/// A ball pressed on that scene's wheel head, 20 s.
LoopPlan on_the_wheel_head(const DeviceModel& device, const HandModel& hand, LoopWall wall);

/// The devices of the table: 45 g; 0.1, 0.5 and 1 N s/m; without and with 0.26 N of friction; 0.055
/// mm; 0 to 3 ticks.
std::vector<DeviceModel> device_list();

}  // namespace onggi::lab
