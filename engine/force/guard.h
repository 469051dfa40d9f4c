#pragma once

#include "engine/math/vec.h"

namespace onggi::force {

struct GuardLimits {
  double max_force = 0;    ///< N, >= 0.
  double max_slew = 0;     ///< N/s, > 0.
  double engage_time = 0;  ///< s of ramp from nothing, > 0.
};

/// The last stage for one hand's force. For any input the output is finite, at most max_force, and
/// changes no faster than max_slew. After release() it stays at zero until the wanted force is
/// small (a hand that arrives deep in the clay is not thrown out), then ramps up.
class Guard {
 public:
  /// One tick of `seconds`. Returns the force to apply, N. `wanted_ok` is false if `wanted` was not
  /// finite: that is a fault, and releases.
  Vec3 step(Vec3 wanted, double seconds, const GuardLimits& limits, bool& wanted_ok) noexcept;

  /// The hand was lifted, has arrived, or its sample is invalid: the force goes to zero, then
  /// engages again.
  void release() noexcept {
    armed_ = false;
    ramp_ = 0.0;
  }
  Vec3 force() const { return force_; }
  double ramp() const { return ramp_; }
  bool armed() const { return armed_; }

 private:
  Vec3 force_;
  double ramp_ = 0.0;  // 0..1
  bool armed_ = false;
};

}  // namespace onggi::force
