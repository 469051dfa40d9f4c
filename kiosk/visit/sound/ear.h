#pragma once

#include "kiosk/visit/sound/heard.h"
#include "kiosk/wheel/loop/status.h"

namespace onggi::sound {

/// The sound of a tick of the wheel; `fire` and `volume` stay 0. A pot that is only shown
/// (LoopStatus::shown) makes no sound. Any thread, no allocation.
Heard hear(const loop::LoopStatus& status) noexcept;

}  // namespace onggi::sound
