#pragma once

#include "kiosk/screens/visit.h"

namespace onggi::measure {

/// A short touch of `visit`'s screen at (x, y) px, down and up again, at `now` (s, the visit's own
/// clock). Main thread.
void tap(screens::Visit& visit, float x, float y, double now);

}  // namespace onggi::measure
