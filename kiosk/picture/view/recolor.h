#pragma once

#include <span>
#include <utility>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Palette colours, each with its replacement.
using Recolors = std::span<const std::pair<Color, Color>>;

/// The replacement for `color`: its alpha is kept, and so are foreign colours (a glaze's, a
/// picture's).
Color recolored(Color color, Recolors by);

/// Recolours all words, fills, borders and lines of `items`. In place; nothing else changes.
void recolor(std::vector<Item>& items, Recolors by);

}  // namespace onggi::view
