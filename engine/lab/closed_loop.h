#pragma once

#include "engine/force/haptics.h"
#include "engine/lab/handle.h"
#include "engine/scene/scene.h"

namespace onggi::lab {

/// What answers a handle's places with forces.
enum class LoopWall {
  spring,           ///< K, two-sided, about where the loop begins.
  maxwell,          ///< K that gives way in theory::kRelaxation.
  filtered_spring,  ///< K behind the paper's Butterworth of 10 Hz.
  engine,           ///< A scene's own force, put on a device as it comes.
  filtered_engine,  ///< The same behind the paper's filter.
  rendered,         ///< A scene's touch through force::Haptics: what ships.
};
/// "spring", "maxwell" ...
const char* name_of(LoopWall wall);

/// A loop of 1 kHz, and what is done in it. What is not a scene's is along y alone.
struct LoopPlan {
  static constexpr double kSeconds = 0.001;  ///< A tick.

  DeviceModel device;
  HandModel hand;
  LoopWall wall = LoopWall::spring;
  double stiffness = 0.0;         ///< Of the three without a scene, N/m.
  SceneDef scene;                 ///< Of the others.
  double coupling = 0.0;          ///< Of `rendered`, N/m.
  int told_delay = -1;            ///< Of `rendered`: what it is told; -1: the truth.
  bool passivity = true;          ///< Of `rendered`: false leaves the coupling alone.
  Vec3 begins{0.12, 0.008, 0.0};  ///< m; as it stands, a ball on the wheel head.
  Vec3 rest = begins;             ///< Where the hand would be, m.
  Vec3 push;                      ///< Of the hand, N.
  Vec3 kick;                      ///< Its speed at the first tick, m/s.
  double wheel = 0.0;             ///< rad/s
  double seconds = 2.0;
};

/// What came of it. Of its last quarter, unless said otherwise.
struct LoopResult {
  double swing = 0.0;       ///< Half of the way from end to end along an axis, m,
                            ///< besides going evenly.
  double before = 0.0;      ///< The same of the quarter before,
  double earlier = 0.0;     ///< and of the one before that.
  double force_step = 0.0;  ///< Largest change of the force from tick to tick, N.
  double force_mean = 0.0;  ///< N
  double stretch = 0.0;     ///< Of the coupling, at its end, m.
  double stiffness = 0.0;   ///< Greatest of a scene's Touch, N/m.
  bool damped = false;      ///< The passivity controller added damping, at any time.

  /// What moves gets less, quarter by quarter; a limit cycle is now wider and now narrower.
  bool dies_away() const { return swing < 0.97 * before && before < 0.97 * earlier; }
  /// What is left moving is less than a limit cycle may be, or dies away.
  bool at_rest() const { return swing < kMostSwing || dies_away(); }
  static constexpr double kMostSwing = 1e-4;  ///< m
};

/// Runs it. A scene that validate() refuses, and a handle that flies off by a metre, give a swing
/// of infinity. Allocates.
LoopResult run_loop(const LoopPlan& plan);

/// Ticks in which a hand is led.
inline constexpr int kLedTicks = 700;
/// The power that a hand has to put into the device, W, which leads it to and fro by `way` (m, each
/// side) about `plan.begins`, along y, `cycles` times in kLedTicks: below zero is what a passive
/// loop never gives. The wheel's work is taken off.
double driven_power(const LoopPlan& plan, double way, int cycles);
/// Of nine frequencies up to nearly half the rate the least, as a damping: power over the mean
/// square of the speed, N s/m.
double least_damping(const LoopPlan& plan, double way);

}  // namespace onggi::lab
