#pragma once

#include "engine/force/hand_velocity.h"

namespace onggi::force {

/// Is a handle faster than any hand that works clay? Then it is a device that runs away, or one
/// that was let go of, and its force has to end. Over the same windows as friction, so that a
/// count of an encoder or a report that came late is not taken for speed. One thread.
class Overspeed {
 public:
  static constexpr double kMost = 1.5;  ///< m/s: twice what throwing takes (engine/docs/force.md).

  /// The handle is at `place` (m), `seconds` after the last. Time that is none is added to the
  /// next.
  bool look(Vec3 place, double seconds, double most = kMost) noexcept {
    waited_ += seconds;
    if (!(waited_ > 0.0)) return false;
    const Vec3 velocity = velocity_.go(place, waited_);
    waited_ = 0.0;
    return dot(velocity, velocity) > most * most;
  }
  void release() noexcept { *this = Overspeed(); }

 private:
  HandVelocity velocity_;
  double waited_ = 0.0;
};

}  // namespace onggi::force
