#pragma once

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

inline constexpr int kStars = 5;

/// Width of a row of kStars stars, `size` high each.
float stars_width(float size);
/// Draws the row from the reading side of `at`, centred on its height; the first `full` are filled.
void draw_stars(Page& page, const view::Rect& at, int full, float size, float opacity = 1);

}  // namespace onggi::screens
