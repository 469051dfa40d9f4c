#pragma once

#include "engine/scene/hands.h"

namespace onggi::device {

/// One tool in the world: reads a visitor's hand, and receives the force for it. While it is
/// attached to the wheel, only the loop thread calls it, and no call may lock, allocate, log or
/// throw. The main thread makes and destroys it (loop::WheelHost).
class HandDevice {
 public:
  virtual ~HandDevice() = default;
  /// The tool now, `dt` seconds after the last read. Studio frame, metres.
  virtual HandInput read(double dt) noexcept = 0;
  /// The result of the last tick; empty if the hand is not at the clay. Devices without force
  /// ignore it.
  virtual void feel(const HandFeedback& feedback) noexcept = 0;
  /// Age of its newest report, s; negative if it has no reports.
  virtual double age() const noexcept { return -1.0; }
  /// True if it has no hand of its own and follows lead().
  virtual bool led() const noexcept { return false; }
  /// The target that the screens set. Only devices that follow a finger or keys use it.
  virtual void lead(const HandInput& /*target*/) noexcept {}
};

}  // namespace onggi::device
