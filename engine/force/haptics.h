#pragma once

#include "engine/force/blow_pulse.h"
#include "engine/force/coupling.h"
#include "engine/force/passivity.h"

namespace onggi::force {

/// The properties of a device that its control loop needs.
struct HapticLimits {
  double stiffness = 0;    ///< N/m, > 0: derived for the device (`onggi lab loop`).
  double max_force = 0;    ///< N, >= 0.
  double mass = 0.045;     ///< Of the handle as it is felt, kg, > 0.
  double own_damping = 0;  ///< N s/m, >= 0.
  int delay = 0;           ///< Ticks from a place to the force that it made, >= 0.

  /// N s/m: limit of a damper made from sampled places. Its lag is the delay, half a tick of the
  /// hold, and the velocity's window; a quarter of what would make it swing.
  double most_damping(double seconds) const {
    return 0.25 * mass / ((delay + 0.5) * seconds + 0.5 * HandVelocity::kWindow);
  }
};

/// A hand at a force device, from its position to its force: coupling, then passivity. A guard
/// always follows last. The kiosk and the laboratory use the same one. One thread.
class Haptics {
 public:
  Vec3 tool(Vec3 hand, double seconds, const HapticLimits& limits) noexcept {
    push_ = pulse_.step(hand - hand_, seconds);
    hand_ = hand;
    seconds_ = seconds;
    return coupling_.tool(hand, seconds, {limits.stiffness, limits.max_force});
  }
  /// Force for the place last given to tool(), which must come first. `share`, 0..1, of the force
  /// is felt. At 0 nothing is felt, and no debt is paid.
  Vec3 feel(const Touch& touch, double share, const HapticLimits& limits) noexcept {
    const Vec3 force =
        share * (coupling_.feel(touch, {limits.stiffness, limits.max_force}) + push_);
    const double most = share > 0.0 ? limits.most_damping(seconds_) : 0.0;
    return passivity_.step(hand_, force, touch, seconds_,
                           {limits.stiffness, limits.own_damping, most, limits.delay});
  }
  /// The hand struck the clay with `force` (N), and is pushed `out` (unit): BlowPulse. The tool in
  /// the clay stays where it is. 0: it struck nothing, and a push ends.
  void strike(double force, Vec3 out) noexcept { pulse_.begin(force, out); }
  void release() noexcept {
    pulse_.release();
    push_ = {};
    coupling_.release();
    passivity_.release();
  }
  const Coupling& coupling() const { return coupling_; }
  const PassivityControl& passivity() const { return passivity_; }

 private:
  Coupling coupling_;
  PassivityControl passivity_;
  BlowPulse pulse_;
  Vec3 hand_, push_;
  double seconds_ = 0;
};

}  // namespace onggi::force
