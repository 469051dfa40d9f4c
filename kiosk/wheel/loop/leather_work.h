#pragma once

#include <array>

#include "engine/force/guard.h"
#include "engine/force/hand_velocity.h"
#include "engine/force/leather_hand.h"
#include "engine/scene/hands.h"

namespace onggi::loop {

/// The loop's side of a leather-hard pot: hands with a decorating tool at its wall. The clay takes
/// no part in it. No call locks, allocates or throws.
class LeatherWork {
 public:
  static constexpr double kComes = 0.3;  ///< s from no force to all of it, as a tool comes to hand,
  static constexpr double kGoes = 0.1;   ///< and back.
  static constexpr double kSilent = 0.1;  ///< s without a word after which the pot turns no more.

  /// From now on `wall` is worked, from no force on. Returns the wall of before, which is its
  /// owner's again; nullptr if there was none.
  force::LeatherOutline* begin(force::LeatherOutline* wall) noexcept;
  /// The force goes down; once it is none, ended() says so.
  void end() noexcept { ending_ = true; }
  /// The wall, once its force has gone down after end(), or at once (`now`); then there is none.
  force::LeatherOutline* ended(bool now = false) noexcept;
  bool on() const { return wall_ != nullptr; }
  /// The tool in every hand, and how the pot stands. Another tool comes once the force of the one
  /// before has gone down.
  void hold(const force::DecoratingTool& tool, const force::LeatherTurn& turn) noexcept;

  /// One tick of `seconds`: what the hands feel. A hand that is not active is lifted.
  std::array<HandFeedback, kMaxHands> step(const std::array<HandInput, kMaxHands>& hands,
                                           double seconds,
                                           const force::GuardLimits& limits) noexcept;
  /// After the tick.
  const force::LeatherPlace& place(int hand) const {
    return hands_[static_cast<std::size_t>(hand)].tool.place();
  }

 private:
  struct Hand {
    force::LeatherHand tool;
    force::Guard guard;
    force::HandVelocity velocity;
  };
  HandFeedback felt_by(Hand& hand, const HandInput& input, double seconds,
                       const force::GuardLimits& limits) noexcept;

  force::LeatherOutline* wall_ = nullptr;  ///< The main thread's; lent.
  force::DecoratingTool tool_, next_;
  force::LeatherTurn turn_;
  double share_ = 0.0, silent_ = 0.0;
  bool ending_ = false;
  std::array<Hand, kMaxHands> hands_;
};

}  // namespace onggi::loop
