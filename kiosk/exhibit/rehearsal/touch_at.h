#pragma once

#include <optional>
#include <string>

#include "kiosk/visit/screens/visit.h"

namespace onggi::rehearsal {

/// A short touch of `visit`'s screen at (x, y) px, down and up, at `now` (s, the visit's own
/// clock). Main thread.
void touch_at(screens::Visit& visit, float x, float y, double now);

/// Where to tap next to make `control` visible: opens one of the throwing screen's drawers, after
/// closing another open one (so at most two taps). Nothing if it is visible, or if no way is known.
std::optional<view::Rect> way_to(const screens::Visit& visit, const std::string& control);

}  // namespace onggi::rehearsal
