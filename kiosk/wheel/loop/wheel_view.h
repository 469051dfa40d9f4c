#pragma once

#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/effects/prints.h"
#include "engine/scene/coil_view.h"
#include "kiosk/wheel/loop/status.h"

namespace onggi::loop {

/// The published state of the wheel, updated once a frame (WheelHost::collect). Screens, picture,
/// score and keepsake read only this about the clay and the hands. Main thread only.
struct WheelView {
  ClayView clay;
  CoilOnRim coil;             ///< Diameter 0: the pot is not built of coils.
  std::vector<Print> prints;  ///< Of blows and hands, as of the last refresh_every_row().
  LoopStatus status;          ///< In the same state as the clay's rows, or newer.
};

}  // namespace onggi::loop
