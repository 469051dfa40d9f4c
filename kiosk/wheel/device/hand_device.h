#pragma once

#include "engine/scene/hands.h"

namespace onggi::device {

/// One tool in the world: where a visitor's hand is, and the force it is to feel. While it is
/// attached to the wheel the loop thread alone calls it, and no call may lock, allocate, log or
/// throw. Made and destroyed by the main thread (loop::PotterHost).
class HandDevice {
 public:
  virtual ~HandDevice() = default;
  /// The tool now, `dt` seconds after the last read. Studio frame, metres.
  virtual HandInput read(double dt) noexcept = 0;
  /// What the last tick gave back; nothing where the hand is not at the clay. Devices without force
  /// ignore it.
  virtual void feel(const HandFeedback& feedback) noexcept = 0;
  /// How old the newest news from it is, s; below 0 where it has none of its own.
  virtual double age() const noexcept { return -1.0; }
  /// It has no hand of its own, and goes where lead() says.
  virtual bool led() const noexcept { return false; }
  /// Where the screens would have it. Only devices that follow a finger or keys have an ear for it.
  virtual void lead(const HandInput& /*target*/) noexcept {}
};

}  // namespace onggi::device
