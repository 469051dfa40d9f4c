#pragma once

#include <array>
#include <cstddef>

#include "engine/math/hash.h"
#include "engine/math/vec.h"

namespace onggi::force {

/// The velocity of a trembling hand from positions in encoder steps. Differences from tick to tick
/// are useless: one count in 1 ms is 0.055 m/s, and friction changes direction at a hundredth of
/// that.
///
/// An anchor follows the hand on a slack leash (the play operator of Krasnosel'skii & Pokrovskii,
/// Systems with Hysteresis, 1989): a tremble within kTremble has no velocity, an even motion keeps
/// its velocity exactly. Of the anchor's way the shortest window back that covers kEnough is used,
/// at most kWindow (Janabi-Sharifi, Hayward & Chen, Discrete-time adaptive windowing for velocity
/// estimation, 2000, with a given way in place of a given fit). Quick hands are seen from tick to
/// tick, slow ones over 4 ms. So the estimate is late by less than 2 ms, or half a longer tick, and
/// by the leash at a start: 0.6 ms at 0.1 m/s. No allocation; the same bits everywhere; one thread.
class HandVelocity {
 public:
  static constexpr double kTremble = 5.5e-5;  ///< m: a count of the coarsest encoder, PHANToM Omni.
  static constexpr double kEnough = 2.0 * kTremble;  ///< m
  static constexpr double kWindow = 0.004;           ///< s

  /// The hand moved to `to` (m) in `seconds` (> 0): returns its velocity, m/s. Zero on arrival.
  Vec3 go(Vec3 to, double seconds) noexcept;
  /// The hand was lifted: the next position is an arrival.
  void release() { known_ = 0; }
  void add_to(StateHash& hash) const;

 private:
  // Places closer than this are not kept, so that shorter ticks need no more room.
  static constexpr std::size_t kRoom = 16;
  static constexpr double kApart = kWindow / kRoom;
  struct Sample {
    double time = 0.0;  // s since the arrival
    Vec3 at;            // m
  };

  std::array<Sample, kRoom> kept_;  // a ring; the newest at newest_
  std::size_t known_ = 0;           // number of them
  std::size_t newest_ = 0;
  double time_ = 0.0;
  Vec3 anchor_;
};

}  // namespace onggi::force
