#pragma once

#include <array>
#include <optional>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/wheel/device/pointer_lead.h"

namespace onggi::screens {

/// Two visitors at one wheel, a hand each: whoever touches the pot's left half works inside,
/// whoever touches its right half outside, at the same time and each at a height of its own. A
/// finger, or a mouse, is whose half it went down on until it lifts; a second one on the same half
/// rests. Arrows move the hand inside, so that a mouse and a keyboard are two hands too.
class TwoHands {
 public:
  explicit TwoHands(const Wheel& wheel)
      : hands_{device::PointerLead({wheel.palm, wheel.palm_radius}, {0, wheel.tool_radius}),
               device::PointerLead({wheel.palm, wheel.palm_radius}, {0, wheel.tool_radius})} {}

  /// `at`: x right of the axis, y height, metres.
  void pointer(const view::InputEvent& event, Vec2 at, const ClayView& clay);
  /// The hand inside: metres away from the axis and upwards.
  void move_by_keys(const ClayView& clay, double outward, double up);
  /// Once a frame; `contact` of each hand of the wheel.
  void follow(const ClayView& clay, double dt, const std::array<bool, kMaxHands>& contact);
  /// The hand outside, as PointerLead's.
  void take_up(device::WallHold::Part broad, device::WallHold::Part fine) {
    hands_[kOutside].take_up(broad, fine);
  }
  void lift();
  /// Hand 0 outside and hand 1 inside.
  std::array<HandInput, kMaxHands> input(Vec3 right) const;

  bool active() const { return hands_[0].active() || hands_[1].active(); }
  bool grabbed() const { return hands_[0].grabbed() || hands_[1].grabbed(); }
  bool inside() const { return hands_[1].active(); }

 private:
  static constexpr std::size_t kOutside = 0, kInside = 1;
  std::array<device::PointerLead, 2> hands_;
  std::array<std::optional<int>, 2> fingers_;  ///< Which one leads each.
};

}  // namespace onggi::screens
