#pragma once

#include "kiosk/wheel/device/hand_device.h"

namespace onggi::device {

/// Motion limits of a hand that a finger or a mouse leads.
struct PointerHandDef {
  double max_speed = 0.35;     ///< m/s, the fastest glide through the air.
  double press_speed = 0.065;  ///< m/s towards the axis and away, while it presses clay.
  double rise_speed = 0.065;   ///< m/s up, down and along the wall, while it presses clay.
  /// S in which it comes off the clay; coming off at once would leave a mark.
  double letting_go = 0.3;
  double settle_time = 0.025;  ///< s, time constant towards the pointer; joins its 60 Hz steps.
};

/// The loop's side of mouse, touch or keys as a HandDevice. PointerLead sets the tool's target once
/// a frame; this class glides there at 1 kHz, and in clay no faster than a potter. (It knows one
/// frame earlier that it is in clay.) Lifted from clay, it comes off slowly. Set down again, it
/// starts at the pointer and does not glide through the clay. The held tool and its pose pass
/// through unchanged.
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
  Vec3 at_;                 ///< Position of the tool, as last read,
  bool down_ = false;       ///< and whether it was set down.
  double pressed_ago_ = 1;  ///< s since it last met clay.
  double leaving_ = 0;      ///< s until it is off.
};

}  // namespace onggi::device
