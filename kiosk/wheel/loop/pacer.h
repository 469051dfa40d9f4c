#pragma once

#include <cstdint>

#include "kiosk/wheel/loop/status.h"

namespace onggi::loop {

/// Turns the moments at which the loop woke into ticks. A late wake makes one longer tick, of 5 ms
/// at the most; what is still owed is paid by the ticks after, so that the clay's time keeps up
/// with the visitor's. Only a stand-still of over a quarter second is given up, and counted. Plain
/// arithmetic.
class Pacer {
 public:
  static constexpr double kTick = 1e-3;
  static constexpr double kLongest = 5e-3;
  static constexpr double kForgiven = 0.25;

  /// Begins at `now_ns` (CLOCK_MONOTONIC).
  void begin(std::int64_t now_ns) noexcept;
  /// The loop woke at `now_ns`, and was to wake at wake_at(). Gives the dt to step, seconds, > 0.
  double wake(std::int64_t now_ns) noexcept;
  /// When to wake next, ns.
  std::int64_t wake_at() const noexcept { return wake_at_; }
  /// The step took until `now_ns`.
  void done(std::int64_t now_ns) noexcept;

  /// Several wakes in a row, the last of them too, missed a whole tick.
  bool strained() const noexcept { return in_a_row_ >= kSeveral; }
  /// How late the last wake was, and how long its tick took, us.
  double wake_us() const noexcept { return wake_us_; }
  double tick_us() const noexcept { return tick_us_; }

  const Deadlines& deadlines() const noexcept { return deadlines_; }
  double owed() const noexcept { return owed_; }

 private:
  std::int64_t last_ns_ = 0, woke_ns_ = 0, wake_at_ = 0;
  double owed_ = 0;
  static constexpr int kSeveral = 3;
  int in_a_row_ = 0;
  double wake_us_ = 0, tick_us_ = 0;
  Deadlines deadlines_;
};

}  // namespace onggi::loop
