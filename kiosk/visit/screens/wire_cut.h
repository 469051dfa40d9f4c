#pragma once

#include <cstdint>

#include "engine/math/vec.h"
#include "kiosk/wheel/loop/potter.h"
#include "kiosk/wheel/loop/wheel_view.h"

namespace onggi::screens {

/// A potter's two hands draw the wire under the pot, level, across the standing wheel, until it is
/// through on the other side. Main thread.
class WireCut {
 public:
  /// `tool`: HandInput::tool of the wire.
  explicit WireCut(std::uint8_t tool) : tool_(tool) {}

  /// Once a frame. `right`: as PointerLead::input. True once the wire has passed the pot; the hands
  /// are lifted then.
  bool update(double dt, const loop::WheelView& wheel, Vec3 right, loop::PotterCommands& potter);

 private:
  std::uint8_t tool_;
  bool begun_ = false;
  double at_ = 0;  ///< m of the wire's middle from the axis.
};

}  // namespace onggi::screens
