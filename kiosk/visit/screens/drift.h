#pragma once

#include "kiosk/visit/screens/layout.h"

namespace onggi::screens {

/// Offset of the page, whole pixels to the right and down.
struct Drift {
  int x = 0, y = 0;
};

/// A still picture burns into a screen over hours. So words, buttons and pot move together, one
/// pixel at a time, too slowly to notice, within a square of up to 24 pixels and at most a quarter
/// of `margin`. `seconds` counts from any start, on a clock that never goes back; at 0 the offset
/// is 0.
Drift drift(double seconds, float margin);

Regions moved(Regions regions, Drift by);

}  // namespace onggi::screens
