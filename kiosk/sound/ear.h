#pragma once

#include "kiosk/loop/status.h"
#include "kiosk/sound/heard.h"

namespace onggi::sound {

/// What a tick of the wheel sounds like; `fire` and `volume` are left 0. While the pot is only
/// shown to whoever passes by (LoopStatus::shown) it makes no sound. Any thread, no allocation.
Heard hear(const loop::LoopStatus& status) noexcept;

}  // namespace onggi::sound
