#pragma once

#include <array>
#include <vector>

#include "engine/lab/closed_loop.h"
#include "engine/lab/stiffness_limit.h"

namespace onggi::lab {

/// The hands of a sweep.
struct NamedHand {
  const char* name;
  HandModel hand;
};
inline constexpr std::array<NamedHand, 3> kLoopHands{
    {{"free", kFreeHand}, {"light", kLightHand}, {"firm", kFirmHand}}};

/// One device, one hand, one kind of wall. N/m. kStiffestCoupling: even the stiffest wall holds.
/// The stiffness of a scene's own force is searched from 224 to 1585 N/m.
struct LoopRow {
  DeviceModel device;
  const char* hand = "";
  LoopWall wall = LoopWall::spring;
  double given = 0.0;    ///< The stiffness to render: the wheel head under 0.5 N, or `allowed`.
  double stable = 0.0;   ///< Up to here it comes to rest. 0: not even the softest does.
  double passive = 0.0;  ///< Up to here it gives back no more than it took. 0: not even the softest
                         ///< does.
  double eigenvalues = 0.0;  ///< The eigenvalues' figure for `stable`; 0: not linear.
  double colgate = 0.0;      ///< Colgate's figure for `passive`; 0: not linear.
  bool rests = false;        ///< At `given`, as shipped, it comes to rest,
  double swing = 0.0;        ///< and half of the remaining motion, m,
  double force_step = 0.0;   ///< and the force's largest step, N.

  /// The lesser of `stable` and `passive` over `given`: below 1 the loop swings or gives energy.
  double margin() const;
};

/// Every hand and every wall of `device`, and the limit that derive_stiffness_limit() gives. About
/// a second; allocates.
std::vector<LoopRow> sweep_device(const DeviceModel& device, const StiffnessLimit& limit);

/// A scene as visitors have it, on the device at its allowed coupling.
struct SceneLoop {
  const char* hand = "";
  bool turning = false;  ///< At 10 rad/s, a ball held 3 mm in the wall; else on the wheel head.
  bool rests = false;
  double swing = 0.0, force_step = 0.0;  ///< m, N
};
/// Every hand, the wheel still and turning, on the grid of loop_scene().
std::vector<SceneLoop> try_scene(const SceneDef& scene, const DeviceModel& device, double coupling);

}  // namespace onggi::lab
