#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace onggi::screens {

/// A stroke of a drawing, point by point (x, y), in a square of 24 with y down.
using PenStroke = std::vector<std::pair<float, float>>;

/// Reads a drawing (ToolShape::drawing) such as "9,22 9,8; arc 12,8 3,4 180 360": strokes separated
/// by ';'. A stroke is a list of points, or an arc of an ellipse: middle, half-axes, first and last
/// angle in degrees, clockwise from the right. Skips a stroke that it cannot read. Allocates.
std::vector<PenStroke> pen_strokes(std::string_view drawing);

}  // namespace onggi::screens
