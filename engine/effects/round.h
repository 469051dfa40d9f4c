#pragma once

#include <algorithm>

#include "engine/math/hash.h"

namespace onggi::effects {

/// A round of turns among rows, by the clock: how far it has come follows from the time alone, so
/// that neither the tick nor the grid decides how late a row is. No allocation.
class Round {
 public:
  /// What a round of so many elements may cost: 131072 elements a millisecond, about 0.15 ms of it.
  /// A finer grid's round is longer: the seconds that it lasts, and `least` at the least.
  static double lasting(double least, double elements) {
    return std::max(least, elements / 131072e3);
  }

  bool over() const { return done_ >= 1.0; }
  void begin() { done_ = 0.0; }
  void stop() { done_ = 1.0; }
  /// Goes on by `seconds`, of a round that lasts `whole`; what is beyond its end stays in
  /// `seconds`. The share that has had its turn by then, 0..1: 1 where it is over.
  double go_on(double& seconds, double whole) noexcept {
    const double rest = (1.0 - done_) * whole;
    if (seconds >= rest * (1.0 - kRounding)) {
      seconds = std::max(seconds - rest, 0.0);
      if (seconds < kRounding * whole) seconds = 0.0;
      done_ = 1.0;
      return 1.0;
    }
    const double part = seconds / whole;
    done_ += part;
    seconds = 0.0;
    // At the nearest tick's end, before or after: on the mean no row is late by half a tick.
    return std::min(done_ + 0.5 * part, 1.0);
  }
  /// The same of so many rows that take turns one after the other.
  int go_on(double& seconds, double whole, int rows) noexcept {
    return static_cast<int>(go_on(seconds, whole) * rows);
  }
  void add_to(StateHash& hash) const { hash.add(done_); }

 private:
  // Ticks that fill a round are no longer than it, nor shorter.
  static constexpr double kRounding = 1e-9;
  double done_ = 1.0;  // 0..1
};

}  // namespace onggi::effects
