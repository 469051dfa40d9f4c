#pragma once

#include "engine/math/vec.h"

namespace onggi::force {

struct GuardLimits {
  double max_force = 0;    ///< N, >= 0.
  double max_slew = 0;     ///< N/s, > 0.
  double engage_time = 0;  ///< s of ramp from nothing, > 0.
};

/// The last word on one hand's force. Whatever goes in, what comes out is finite, no larger than
/// max_force, and changes no faster than max_slew. After release() it stays at zero until the force
/// wanted is small (a hand that arrives deep in the clay is not thrown out), then ramps up.
class Guard {
 public:
  /// One tick. False in `wanted_ok` when `wanted` was not finite: it is taken as a fault, and
  /// released. N, s.
  Vec3 step(Vec3 wanted, double seconds, const GuardLimits& limits, bool& wanted_ok) noexcept;

  /// The hand was lifted, arrives, or its sample cannot be trusted: towards zero, then engage
  /// again.
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
