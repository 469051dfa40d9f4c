#pragma once

#include "engine/clay/clay_view.h"
#include "kiosk/wheel/loop/status.h"

namespace onggi::loop {

/// The wheel as it is looked at: what the loop has published, renewed once a frame
/// (PotterHost::collect). Screens, picture, score and keepsake read this and nothing else of the
/// clay and the hands. Main thread only.
struct WheelView {
  ClayView clay;
  LoopStatus status;  ///< In the same state as the clay's rows, or newer.
};

}  // namespace onggi::loop
