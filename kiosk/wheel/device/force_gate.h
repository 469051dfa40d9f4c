#pragma once

#include <cstdint>

#include "engine/force/guard.h"
#include "kiosk/wheel/device/device_sample.h"

namespace onggi::device {

/// Limits for the force on a person's hand.
struct ForceLimits {
  double cap = 0.0;          ///< N, >= 0.
  double slew = 600.0;       ///< N/s, > 0: for every change except the stop.
  double engage_time = 0.5;  ///< s, > 0: from zero to full force.
};

/// The last stage before the cable, always on: the engine's guard with the device's own limits, and
/// an immediate stop. A fault makes the force zero in the same step, without slew, so that a
/// released handle is not pushed. Then it engages again, when the wanted force is small and
/// starting from zero. One thread. No allocation, no throw.
class ForceGate {
 public:
  /// `wanted` N; `seconds` since the last step (limited to 5 ms). `fault`: the caller's fault; the
  /// gate adds not_a_number. Returns the force for the cable.
  Vec3 step(Vec3 wanted, double seconds, const ForceLimits& limits, LinkFault& fault) noexcept;
  /// Zero now, then engage again: when not armed, unplugged, or at the end.
  void cut() noexcept { guard_ = {}; }
  Vec3 force() const noexcept { return guard_.force(); }

 private:
  force::Guard guard_;
};

/// `force` in whole millinewtons, rounded towards zero so that it never exceeds a limit.
Vec3 whole_millinewtons(Vec3 force) noexcept;

}  // namespace onggi::device
