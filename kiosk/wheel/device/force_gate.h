#pragma once

#include <cstdint>

#include "engine/force/guard.h"
#include "kiosk/wheel/device/device_sample.h"

namespace onggi::device {

/// What a hand at a force device may feel.
struct ForceLimits {
  double cap = 0.0;          ///< N, >= 0.
  double slew = 600.0;       ///< N/s, > 0: of every change but the end.
  double engage_time = 0.5;  ///< s, > 0: from nothing to all.
};

/// Last before the wire, always on: the engine's guard with the device's own limits, and an end
/// that is at once. A fault makes the force zero in this very step (no slew: a hand that is let go
/// of is not pushed), and then it engages anew, from a small wish and from nothing. One thread. No
/// allocation, no throw.
class ForceGate {
 public:
  /// `wanted` N, `seconds` since the last step (cut to 5 ms). `fault`: as seen by the caller; the
  /// gate adds not_a_number. Gives what may go on the wire.
  Vec3 step(Vec3 wanted, double seconds, const ForceLimits& limits, LinkFault& fault) noexcept;
  /// Zero now, and engage anew: not armed yet, unplugged, at the end.
  void cut() noexcept { guard_ = {}; }
  Vec3 force() const noexcept { return guard_.force(); }

 private:
  force::Guard guard_;
};

/// `force` shortened to whole millinewtons, towards zero, so that rounding never passes a cap.
Vec3 whole_millinewtons(Vec3 force) noexcept;

}  // namespace onggi::device
