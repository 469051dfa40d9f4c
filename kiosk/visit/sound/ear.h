#pragma once

#include "kiosk/visit/sound/heard.h"
#include "kiosk/wheel/loop/status.h"

namespace onggi::sound {

/// The sound of the wheel's last tick, with `fire` and `volume` 0. A pot that is only shown
/// (LoopStatus::shown) is silent. Any thread, no allocation.
Heard hear(const loop::LoopStatus& status) noexcept;

}  // namespace onggi::sound
