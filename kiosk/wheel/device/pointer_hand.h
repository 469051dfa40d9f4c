#pragma once

#include "kiosk/wheel/device/hand_device.h"

namespace onggi::device {

/// How a hand moves that is led by a finger or a mouse.
struct PointerHandDef {
  double max_speed = 0.35;     ///< m/s, the fastest glide through the air.
  double press_speed = 0.065;  ///< m/s towards the axis and away, while it presses clay.
  double rise_speed = 0.065;   ///< m/s up, down and along the wall, while it presses clay.
  double letting_go = 0.3;  ///< s in which it comes off clay: all at once, it would leave a mark.
  double settle_time = 0.025;  ///< s, time constant towards the pointer; joins its 60 Hz steps.
};

/// Mouse, touch or keys as a HandDevice, the loop's half: PointerLead says at frame rate where the
/// tool is to be, and here it glides there at 1 kHz; in clay, which is known here a frame sooner
/// than there, no faster than a potter. Lifted from clay it comes off slowly; set down anew it is
/// where the pointer is, without gliding through the clay. What is held, and how, passes through.
class PointerHand final : public HandDevice {
 public:
  PointerHand() = default;
  explicit PointerHand(const PointerHandDef& def) : def_(def) {}
  void lead(const HandInput& target) noexcept override;
  bool led() const noexcept override { return true; }
  HandInput read(double dt) noexcept override;
  void feel(const HandFeedback& felt) noexcept override;

 private:
  HandInput come_off(double dt) noexcept;

  PointerHandDef def_;
  HandInput target_;
  HandInput held_;          ///< As last read while it was led.
  Vec3 at_;                 ///< Of the tool, as last read,
  bool down_ = false;       ///< and whether it was set down.
  double pressed_ago_ = 1;  ///< s since it last met clay.
  double leaving_ = 0;      ///< s until it is off.
};

}  // namespace onggi::device
