#pragma once

#include "engine/force/decorating_tool.h"
#include "engine/force/haptics.h"
#include "engine/lab/handle.h"
#include "engine/scene/scene.h"

namespace onggi::lab {

/// What answers a handle's places with forces.
enum class LoopWall {
  spring,           ///< K, two-sided, about where the loop begins.
  maxwell,          ///< K that gives way in theory::kRelaxation.
  filtered_spring,  ///< K behind the paper's Butterworth of 10 Hz.
  engine,           ///< A scene's own force, directly on the device.
  filtered_engine,  ///< The same behind the paper's filter.
  rendered,         ///< A scene's touch through force::Haptics: the shipped path.
  leather,          ///< A decorating tool on a level of leather-hard clay at y = 0, rendered so.
};
/// "spring", "maxwell" ...
const char* name_of(LoopWall wall);

/// A loop of 1 kHz and its task. Walls that are no scene act along y alone.
struct LoopPlan {
  static constexpr double kSeconds = 0.001;  ///< A tick.

  DeviceModel device;
  HandModel hand;
  LoopWall wall = LoopWall::spring;
  double stiffness = 0.0;         ///< Of the three walls without a scene, N/m.
  SceneDef scene;                 ///< Of the walls with a scene; of `leather` its guard alone.
  force::DecoratingTool tool;     ///< Of `leather`.
  double coupling = 0.0;          ///< Of `rendered` and `leather`, N/m.
  int told_delay = -1;            ///< Of both: the delay that they are told; -1: the true one.
  bool passivity = true;          ///< Of both: false switches the passivity controller off.
  Vec3 begins{0.12, 0.008, 0.0};  ///< m; default: a ball on the wheel head.
  Vec3 rest = begins;             ///< Where the hand wants to be, m.
  Vec3 push;                      ///< The hand's own push, N.
  Vec3 kick;                      ///< Speed at the first tick, m/s.
  double wheel = 0.0;             ///< rad/s
  bool paddle = false;  ///< Of `rendered`: the hand holds a paddle, for which the wall is firm.
  double beats = 0.0;   ///< Then: s from blow to blow, a third of which it lies; 0: none.
  Vec3 lead{0.0, 1.0, 0.0};  ///< driven_power() leads along it; unit.
  double seconds = 2.0;
};

/// Result of a loop, over its last quarter unless said otherwise.
struct LoopResult {
  double swing = 0.0;    ///< Half of the way from end to end along an axis, less any even drift, m.
  double before = 0.0;   ///< The same in the quarter before,
  double earlier = 0.0;  ///< and in the one before that.
  double force_step = 0.0;  ///< Largest change of the force from tick to tick, N.
  double force_mean = 0.0;  ///< N

  /// The swing shrinks from quarter to quarter; a limit cycle's varies.
  bool dies_away() const { return swing < 0.97 * before && before < 0.97 * earlier; }
  /// The remaining swing is below kMostSwing, or dies away.
  bool at_rest() const { return swing < kMostSwing || dies_away(); }
  static constexpr double kMostSwing = 1e-4;  ///< m
};

/// Runs the loop. The swing is infinite if validate() refuses the scene or the handle flies off by
/// a metre. Allocates.
LoopResult run_loop(const LoopPlan& plan);

/// Ticks in which a hand is led.
inline constexpr int kLedTicks = 700;
/// The power (W) that a hand has to put into the device to lead it to and fro by `way` (m, each
/// side) about `plan.begins`, along `plan.lead`, `cycles` times in kLedTicks. A passive loop never
/// gives less than zero. The wheel's work is taken off.
double driven_power(const LoopPlan& plan, double way, int cycles);
/// The least of nine frequencies up to nearly half the rate, as a damping: power over the mean
/// square of the speed, N s/m.
double least_damping(const LoopPlan& plan, double way);

}  // namespace onggi::lab
