#pragma once

#include "engine/force/hand_velocity.h"

namespace onggi::force {

/// Detects a handle that is faster than any hand at work: the device is out of control or was
/// released, and its force must end. It uses the same windows as friction, so that an encoder count
/// or a late report does not look like speed. One thread.
class Overspeed {
 public:
  static constexpr double kMost = 1.5;  ///< m/s: twice what throwing takes (engine/docs/force.md).

  /// The handle is at `place` (m), `seconds` after the last call. An invalid time is added to the
  /// next one.
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
