#pragma once

#include "kiosk/device/hand_device.h"

namespace onggi::device {

/// How a hand moves that is led by a finger or a mouse.
struct PointerHandDef {
  double max_speed = 0.35;     ///< m/s, the fastest glide. A hand shaping clay stays well below.
  double settle_time = 0.025;  ///< s, time constant towards the pointer; joins its 60 Hz steps.
};

/// Mouse, touch or keys as a HandDevice, the loop's half: PointerLead says at frame rate where the
/// tool is to be, and here it glides there at 1 kHz. A lifted tool is set down where the pointer
/// is, without gliding through the clay. What is held, and how, passes through.
class PointerHand final : public HandDevice {
 public:
  PointerHand() = default;
  explicit PointerHand(const PointerHandDef& def) : def_(def) {}
  void lead(const HandInput& target) noexcept override {
    target_ = target;
    down_ = down_ && target.active;
  }
  HandInput read(double dt) noexcept override;
  void feel(const HandFeedback&) noexcept override {}

 private:
  PointerHandDef def_;
  HandInput target_;
  Vec3 at_;            ///< Of the tool, as last read,
  bool down_ = false;  ///< and whether it was set down.
};

}  // namespace onggi::device
