#pragma once

#include <array>
#include <atomic>

#include "kiosk/wheel/loop/histogram.h"

namespace onggi::loop {

/// How well the loop keeps time: what each wake, tick and device had, since the loop began.
struct LoopTiming {
  Histogram wake_us;     ///< From when it was to wake until it did.
  Histogram compute_us;  ///< Of a tick.
  Histogram device_us;   ///< Age of a device's newest report as a tick took it.
};

/// A histogram that one thread adds to while any other may look. Neither waits; no allocation.
class LiveHistogram {
 public:
  /// Its thread's.
  void add(double us) noexcept;
  /// Anybody's: every count as it is at some moment of the call.
  Histogram look() const noexcept;

 private:
  std::array<std::atomic<std::uint32_t>, Histogram::kBins> counts_{};
  std::atomic<double> most_{0.0};
};

}  // namespace onggi::loop
