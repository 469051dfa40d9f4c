#pragma once

#include <array>
#include <cstddef>

#include "engine/force/hand_velocity.h"
#include "engine/force/tool_touch.h"

namespace onggi::force {

/// The properties of a device that a passivity controller needs.
struct PassivityLimits {
  double stiffness = 0;     ///< N/m, > 0: of the coupling, which can store that much.
  double own_damping = 0;   ///< N s/m, >= 0: damping that the device certainly has.
  double most_damping = 0;  ///< N s/m, >= 0: limit of added damping.
  int delay = 0;            ///< Ticks until a force is felt, 0..kMostDelay; more counts as that.
};

/// Time-domain passivity control (Hannaford & Ryu 2002; Ryu, Kim & Hannaford 2004): a ledger of the
/// energy that went into the clay through the hand, by the sampled places and the forces that were
/// held between them, which is exact. Overdrawn, the force gets as much damping as pays it back.
///
/// The wheel is a motor: what it does to the hand through the clay is its own work, and credited
/// (force times the clay's velocity). Clay does not give back what it took, so no credit is more
/// than what the coupling's spring and the clay's can hold now; and no debt more than kMostDebt, so
/// that an old one is not paid for ever. No allocation; the same bits everywhere; one thread.
class PassivityControl {
 public:
  static constexpr int kMostDelay = 8;
  static constexpr double kMostDebt = 0.002;  ///< J

  /// The hand is at `hand` (m), `seconds` (> 0) after the last call; it is to feel `force` (N).
  /// What it may feel.
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
