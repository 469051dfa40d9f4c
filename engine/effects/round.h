#pragma once

#include <algorithm>

#include "engine/math/hash.h"

namespace onggi::effects {

/// A round of turns among rows, by the clock. Progress follows from time alone, so neither the tick
/// nor the grid decides how late a row's turn is. No allocation.
class Round {
 public:
  /// Length of a round over so many elements, s: at most 131072 elements a millisecond, about 0.15
  /// ms of work in each, and at least `least`. So a finer grid's round is longer.
  static double lasting(double least, double elements) {
    return std::max(least, elements / 131072e3);
  }

  bool over() const { return done_ >= 1.0; }
  void begin() { done_ = 0.0; }
  void stop() { done_ = 1.0; }
  /// Advances a round that lasts `whole` by `seconds`; time beyond its end stays in `seconds`.
  /// Returns the share that has had its turn, 0..1: 1 when it is over.
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
    // Rounded to the nearest tick's end: on average no row is late by half a tick.
    return std::min(done_ + 0.5 * part, 1.0);
  }
  /// The same for `rows` rows that take turns one after the other.
  int go_on(double& seconds, double whole, int rows) noexcept {
    return static_cast<int>(go_on(seconds, whole) * rows);
  }
  void add_to(StateHash& hash) const { hash.add(done_); }

 private:
  // Tolerance, so that ticks that exactly fill a round also end it.
  static constexpr double kRounding = 1e-9;
  double done_ = 1.0;  // 0..1
};

}  // namespace onggi::effects
