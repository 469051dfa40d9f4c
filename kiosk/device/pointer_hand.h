#pragma once

#include "kiosk/device/hand_device.h"

namespace onggi::device {

/// How a hand moves that is led by a finger or a mouse.
struct PointerHandDef {
  double max_speed = 0.35;     ///< m/s, the fastest glide. A hand shaping clay stays well below.
  double settle_time = 0.025;  ///< s, time constant towards the pointer; joins its 60 Hz steps.
};

/// Mouse or touch as a HandDevice: the pointer sets a target at frame rate, the tool glides there
/// at 1 kHz. A lifted tool is set down where the pointer is, without gliding through the clay.
class PointerHand final : public HandDevice {
 public:
  PointerHand() = default;
  explicit PointerHand(const PointerHandDef& def) : def_(def) {}
  /// The newest target. Same thread as read().
  void aim(const HandInput& target) noexcept;
  HandInput read(double dt) noexcept override;
  void feel(const HandFeedback&) noexcept override {}

 private:
  PointerHandDef def_;
  HandInput target_;
  HandInput hand_;
};

}  // namespace onggi::device
