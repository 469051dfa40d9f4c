#pragma once

#include <array>
#include <optional>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/wheel/device/pointer_lead.h"

namespace onggi::screens {

/// Two visitors at one wheel, a hand each. A touch on the pot's left half works inside, one on its
/// right half outside, at the same time and each at its own height. A finger or mouse belongs to
/// the half where it went down until it lifts; a second one on the same half is ignored. Arrow keys
/// move the inside hand, so a mouse and a keyboard also make two hands.
class TwoHands {
 public:
  explicit TwoHands(const SceneForVisitor& wheel)
      : hands_{device::PointerLead({wheel.palm, wheel.palm_radius}, {0, wheel.tool_radius}),
               device::PointerLead({wheel.palm, wheel.palm_radius}, {0, wheel.tool_radius})} {}

  /// `at`: x right of the axis, y height, metres.
  void pointer(const view::InputEvent& event, Vec2 at, const ClayView& clay);
  /// The inside hand: metres away from the axis and upwards.
  void move_by_keys(const ClayView& clay, double outward, double up);
  /// Call once a frame; `contact` of each hand of the wheel.
  void follow(const ClayView& clay, double dt, const std::array<bool, kMaxHands>& contact);
  /// The outside hand, as in PointerLead.
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
  std::array<std::optional<int>, 2> fingers_;  ///< The finger that leads each hand.
};

}  // namespace onggi::screens
