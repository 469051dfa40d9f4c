#pragma once

#include <array>
#include <atomic>

#include "kiosk/wheel/loop/histogram.h"

namespace onggi::loop {

/// The loop's timing since it began: every wake, tick and device.
struct LoopTiming {
  Histogram wake_us;     ///< Delay of a wake.
  Histogram compute_us;  ///< Duration of a tick.
  Histogram device_us;   ///< Age of a device's newest report when a tick took it.
};

/// A histogram that one thread adds to while others read. Neither waits; no allocation.
class LiveHistogram {
 public:
  /// Its own thread.
  void add(double us) noexcept;
  /// Any thread: every count at some moment during the call.
  Histogram look() const noexcept;

 private:
  std::array<std::atomic<std::uint32_t>, Histogram::kBins> counts_{};
  std::atomic<double> most_{0.0};
};

}  // namespace onggi::loop
