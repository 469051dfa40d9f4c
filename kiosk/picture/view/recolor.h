#pragma once

#include <span>
#include <utility>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Colours of the palette, each with the one that stands in its place.
using Recolors = std::span<const std::pair<Color, Color>>;

/// What `color` becomes: its alpha is kept, and so is a colour that is not among them (a glaze's, a
/// picture's).
Color recolored(Color color, Recolors by);

/// Every word, filling, border and line of `items`. In place; nothing else changes.
void recolor(std::vector<Item>& items, Recolors by);

}  // namespace onggi::view
