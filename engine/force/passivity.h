#pragma once

#include <array>
#include <cstddef>

#include "engine/force/hand_velocity.h"
#include "engine/force/tool_touch.h"

namespace onggi::force {

/// The properties of a device that a passivity controller needs.
struct PassivityLimits {
  double stiffness = 0;     ///< N/m, > 0: of the coupling, which can store energy.
  double own_damping = 0;   ///< N s/m, >= 0: damping that the device has in any case.
  double most_damping = 0;  ///< N s/m, >= 0: limit of added damping.
  int delay = 0;            ///< Ticks until a force is felt, 0..kMostDelay; larger values count as
                            ///< kMostDelay.
};

/// Time-domain passivity control (Hannaford & Ryu 2002; Ryu, Kim & Hannaford 2004): an exact ledger
/// of the energy that went into the clay through the hand, by sampled places and the forces held
/// between them. When it is overdrawn, damping on the force pays it back.
///
/// The wheel is a motor. Its work on the hand through the clay (force times the clay's velocity) is
/// credited. Clay gives next to nothing back of what it took (engine/docs/contact.md), so no credit
/// exceeds what the coupling's and the clay's springs can hold now; no debt exceeds kMostDebt, so
/// that an old one is not paid for ever. No allocation; the same bits everywhere; one thread.
class PassivityControl {
 public:
  static constexpr int kMostDelay = 8;
  static constexpr double kMostDebt = 0.002;  ///< J

  /// The hand is at `hand` (m), `seconds` (> 0) after the last call, and should feel `force` (N).
  /// Returns what it may feel.
  Vec3 step(Vec3 hand, Vec3 force, const Touch& touch, double seconds,
            const PassivityLimits& limits) noexcept;
  void release() noexcept { *this = PassivityControl(); }
  double energy() const { return energy_; }    ///< In the ledger, J.
  double damping() const { return damping_; }  ///< Added in the last step, N s/m.

 private:
  struct Given {
    Vec3 force, clay;
  };
  std::array<Given, kMostDelay + 1> given_{};  ///< A ring; the newest at newest_.
  std::size_t newest_ = 0;
  HandVelocity velocity_;
  Vec3 hand_;
  double energy_ = 0.0, damping_ = 0.0;
  bool known_ = false;
};

}  // namespace onggi::force
