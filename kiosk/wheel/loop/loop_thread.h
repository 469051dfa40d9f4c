#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "kiosk/wheel/loop/pacer.h"
#include "kiosk/wheel/loop/status_block.h"
#include "kiosk/wheel/loop/tick_timing.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::loop {

/// The 1 kHz thread that owns the clay: it wakes at absolute times of CLOCK_MONOTONIC, with
/// real-time priority if the system permits. It never locks, allocates, logs or opens a file.
class LoopThread final : public WheelHost {
 public:
  LoopThread();
  ~LoopThread() override;  ///< Stops within a tick and joins.
  LoopStatus status() const override { return block_.read(); }
  /// Its timing so far, at any moment.
  LoopTiming timing() const;
  /// What the system did not permit, a sentence each, for the log; asked once after the start.
  std::vector<std::string> remarks() const;

 private:
  void run();
  void let_loop_turn() override {}

  StatusBlock<LoopStatus> block_;
  std::atomic<bool> stop_{false};
  LiveHistogram wake_us_, compute_us_, device_us_;
  std::atomic<int> lock_error_{0};  ///< errno of locking memory; 0 on success.
  std::atomic<int> priority_error_{
      -1};  ///< errno of requesting SCHED_FIFO; 0 granted, -1 not requested yet.
  std::thread thread_;
};

}  // namespace onggi::loop
