#pragma once

#include <cstdint>

#include "kiosk/wheel/loop/status.h"

namespace onggi::loop {

/// Turns the loop's wake times into ticks. A late wake makes one longer tick of at most 5 ms; later
/// ticks pay the rest, so that the clay's time keeps up with the visitor's. Only a pause of over a
/// quarter second is dropped, and counted. Plain arithmetic.
class Pacer {
 public:
  static constexpr double kTick = 1e-3;
  static constexpr double kLongest = 5e-3;
  static constexpr double kForgiven = 0.25;

  /// Begins at `now_ns` (CLOCK_MONOTONIC).
  void begin(std::int64_t now_ns) noexcept;
  /// The loop woke at `now_ns`, and should have at wake_at(). Returns the dt to step, seconds, > 0.
  double wake(std::int64_t now_ns) noexcept;
  /// When to wake next, ns.
  std::int64_t wake_at() const noexcept { return wake_at_; }
  /// The step ended at `now_ns`.
  void done(std::int64_t now_ns) noexcept;

  /// True if several wakes in a row, including the last, missed a whole tick.
  bool strained() const noexcept { return in_a_row_ >= kSeveral; }
  /// How late the last wake was, and how long its tick took, us.
  double wake_us() const noexcept { return wake_us_; }
  double tick_us() const noexcept { return tick_us_; }

  const Deadlines& deadlines() const noexcept { return deadlines_; }

 private:
  std::int64_t last_ns_ = 0, woke_ns_ = 0, wake_at_ = 0;
  double owed_ = 0;
  static constexpr int kSeveral = 3;
  int in_a_row_ = 0;
  double wake_us_ = 0, tick_us_ = 0;
  Deadlines deadlines_;
};

}  // namespace onggi::loop
