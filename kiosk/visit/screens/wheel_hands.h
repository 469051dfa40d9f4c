#pragma once

#include <array>
#include <optional>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/two_hands.h"
#include "kiosk/wheel/device/pointer_lead.h"

namespace onggi::screens {

/// The hands at the wheel that pointers and keys lead: both of one visitor, or one of each of two.
class WheelHands {
 public:
  static constexpr double kNotch = 0.002;  ///< m for a scroll notch or a key press.

  /// `two`: two visitors with a hand each.
  WheelHands(const SceneForVisitor& wheel, bool two)
      : lead_({wheel.palm, wheel.palm_radius}, {0, wheel.tool_radius}) {
    if (two) two_.emplace(wheel);
  }

  /// `at`: x right of the axis, y height, metres. `tool`: a tool is held. True if the hands must be
  /// sent to the wheel.
  bool pointer(const view::InputEvent& event, Vec2 at, const ClayView& clay, device::Grip grip,
               bool tool);
  /// Metres away from the axis and upwards; `sign`: the side where they begin, as in PointerLead.
  void move_by_keys(const ClayView& clay, device::Grip grip, double sign, double outward,
                    double up);
  /// Call once a frame, while active().
  void follow(const ClayView& clay, double dt, const std::array<bool, kMaxHands>& contact);
  /// As in PointerLead; with two visitors the outside hand takes it.
  void take_up(device::WallHold::Part broad, device::WallHold::Part fine);
  void lift();
  /// Tells the wheel where they are, as seen by `camera`.
  void send(const Desk& desk, const view::Camera& camera) const;

  bool two() const { return two_.has_value(); }
  bool active() const { return lead_.active() || (two_ && two_->active()); }
  bool grabbed() const { return lead_.grabbed() || (two_ && two_->grabbed()); }
  bool inside() const { return lead_.inside() || (two_ && two_->inside()); }
  /// Both hands, for code that moves them for a while: "Show me" and requested strokes.
  device::PointerLead& lead() { return lead_; }

 private:
  device::PointerLead lead_;
  std::optional<TwoHands> two_;
};

}  // namespace onggi::screens
