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

/// One device, one hand, one kind of wall. N/m; kStiffestCoupling: the stiffest there is holds. A
/// scene's own force goes from 224 to 1585 N/m there.
struct LoopRow {
  DeviceModel device;
  const char* hand = "";
  LoopWall wall = LoopWall::spring;
  double given = 0.0;        ///< What it is to render: the wheel head under 0.5 N, or `allowed`.
  double stable = 0.0;       ///< Up to here it comes to rest. 0: not the softest.
  double passive = 0.0;      ///< Up to here it gives back no more than it took. 0: likewise.
  double eigenvalues = 0.0;  ///< What the sampled system's say of `stable`; 0: not linear.
  double colgate = 0.0;      ///< What Colgate says of `passive`; 0: not linear.
  bool rests = false;        ///< `given`, as it would ship, comes to rest,
  double swing = 0.0;        ///< with half of that left moving, m,
  double force_step = 0.0;   ///< and this as the force's largest step, N.

  /// The lesser of `stable` and `passive` over `given`: below 1 it howls or gives energy.
  double margin() const;
};

/// Every hand and every wall of `device`, with what derive_stiffness_limit() gave. About a second;
/// allocates.
std::vector<LoopRow> sweep_device(const DeviceModel& device, const StiffnessLimit& limit);

/// A scene as a visitor has it, on the device at the coupling it is allowed.
struct SceneLoop {
  const char* hand = "";
  bool turning = false;  ///< At 10 rad/s, a ball held 3 mm in the wall; else on the wheel head.
  bool rests = false;
  double swing = 0.0, force_step = 0.0;  ///< m, N
};
/// Every hand, the wheel still and turning. What a scene says of its grid is left at that of
/// loop_scene().
std::vector<SceneLoop> try_scene(const SceneDef& scene, const DeviceModel& device, double coupling);

}  // namespace onggi::lab
