#pragma once

#include <optional>
#include <string>

#include "kiosk/visit/screens/visit.h"

namespace onggi::rehearsal {

/// A short touch of `visit`'s screen at (x, y) px, down and up again, at `now` (s, the visit's own
/// clock). Main thread.
void tap(screens::Visit& visit, float x, float y, double now);

/// Where to tap next so that `control` comes onto the screen: one of the throwing screen's drawers,
/// to be opened, after another that is open has been closed (so at most two taps). Nothing where it
/// is there, or no way is known.
std::optional<view::Rect> way_to(const screens::Visit& visit, const std::string& control);

}  // namespace onggi::rehearsal
