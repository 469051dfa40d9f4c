#pragma once

#include "kiosk/visit/sound/heard.h"
#include "kiosk/wheel/loop/status.h"

namespace onggi::sound {

/// What a tick of the wheel sounds like; `fire` and `volume` are left 0. While the pot is only
/// shown to whoever passes by (LoopStatus::shown) it makes no sound. Any thread, no allocation.
Heard hear(const loop::LoopStatus& status) noexcept;

}  // namespace onggi::sound
