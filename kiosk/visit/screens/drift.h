#pragma once

#include "kiosk/visit/screens/layout.h"

namespace onggi::screens {

/// How far the page lies from its place, whole pixels to the right and down.
struct Drift {
  int x = 0, y = 0;
};

/// What stands still for hours burns into a screen: so words, buttons and pot wander together, a
/// pixel at a time and too slowly to be seen, over a square of up to 24 pixels, and never farther
/// than a quarter of `margin` from their place. `seconds` since any beginning, on a clock that
/// never goes back; at 0 they are in their place.
Drift drift(double seconds, float margin);

/// `regions` where the drift has brought them.
Regions moved(Regions regions, Drift by);

}  // namespace onggi::screens
