#pragma once

#include "engine/clay/clay.h"
#include "engine/script/plan.h"
#include "engine/script/ring_plan.h"

namespace onggi::script {

/// The script that beats the wall between paddle and anvil, from the foot to the rim, on a slow
/// wheel. Without BeatingDef the hands do the same moves. Allocates; not for the tick.
Plan beat_wall;

/// A hand that beats the wall from the foot to the rim, and down again, and so on. Allocates
/// nothing.
class PaddleUp {
 public:
  static constexpr double kSpeed = 2.0;  ///< rad/s of the wheel at pace 1.
  /// How near to floor and rim the middle of a blow may be, faces.
  static constexpr double kFromFoot = 0.2, kFromRim = 0.15;

  /// `pace` multiplies the blows' rhythm. `plan`: says how hard each blow is; null: every one full.
  PaddleUp(const SceneDef& scene, double pace, const RingPlan* plan);

  /// The hand `t` seconds after it began; `share`: 0 at the foot, 1 at the rim.
  HandInput at(double t, double share, const Clay& clay) noexcept;

 private:
  double face_, ball_;
  double beat_, lies_;  // s
  const RingPlan* plan_;
  Swings swings_;        // of the blow under way
  double height_ = 0.0;  // m, of the blow under way
  bool lay_ = false;     // at the last call
};

}  // namespace onggi::script
