#pragma once

#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::loop {

/// A wheel that turns only on request: the same core as the 1 kHz thread, stepped 1 ms at a time on
/// the calling thread. Scripted visits use it, so that the same visit gives the same bits at any
/// speed.
class SteppedWheel final : public WheelHost {
 public:
  /// Steps `ticks` of 1 ms.
  void advance(int ticks);
  LoopStatus status() const override { return core_.status(); }

 private:
  void let_loop_turn() override { core_.take_commands(); }
};

}  // namespace onggi::loop
