#pragma once

#include <utility>

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// A translucent hand that points with its index finger, the tip at `tip`; it fades at the wrist.
/// `finger`: the finger's width, pixels. `shown`: 0..1. It comes from the lower right, or on a
/// mirrored page from the lower left.
void draw_pointing_hand(Page& page, std::pair<float, float> tip, float finger, float shown);

}  // namespace onggi::screens
