#pragma once

#include <cstdint>

#include "engine/math/vec.h"
#include "kiosk/wheel/loop/wheel_commands.h"
#include "kiosk/wheel/loop/wheel_view.h"

namespace onggi::screens {

/// A potter's two hands draw the wire under the pot, level, across the stopped wheel, until it
/// comes out on the other side. Main thread.
class WireCut {
 public:
  /// `tool`: HandInput::tool of the wire.
  explicit WireCut(std::uint8_t tool) : tool_(tool) {}

  /// Call once a frame. `right`: as in PointerLead::input. True when the wire has passed the pot;
  /// the hands are then lifted.
  bool update(double dt, const loop::WheelView& wheel, Vec3 right,
              loop::WheelCommands& wheel_commands);

 private:
  std::uint8_t tool_;
  bool begun_ = false;
  double at_ = 0;  ///< The wire's middle, m from the axis.
};

}  // namespace onggi::screens
