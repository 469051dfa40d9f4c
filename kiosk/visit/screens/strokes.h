#pragma once

#include <utility>
#include <vector>

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// Pixels.
using Points = std::vector<std::pair<float, float>>;

/// A line of `width` pixels on a pale halo, which is visible on any background.
void draw_stroke(Page& page, const Points& points, view::Color color, float width);

/// The same as dashes of `dash` pixels with equal gaps.
void draw_dashes(Page& page, const Points& points, view::Color color, float width, float dash);

}  // namespace onggi::screens
