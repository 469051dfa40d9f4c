#pragma once

#include "engine/scene/hands.h"

namespace onggi::device {

/// One tool in the world: where a visitor's hand is, and the force it is to feel. Owned and called
/// by the loop thread alone; neither call may lock, allocate, log or throw.
class HandDevice {
 public:
  virtual ~HandDevice() = default;
  /// The tool now, `dt` seconds after the last read. Studio frame, metres.
  virtual HandInput read(double dt) noexcept = 0;
  /// What the last tick gave back. Devices without force ignore it.
  virtual void feel(const HandFeedback& feedback) noexcept = 0;
};

}  // namespace onggi::device
