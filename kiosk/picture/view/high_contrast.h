#pragma once

#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Converts a frame's items to higher contrast: each palette colour becomes its darker neighbour,
/// so that words have at least 7:1 on their ground (WCAG 2.2, 1.4.6); lines and borders become
/// heavier, and the guides' halos solid. Other opacity and foreign colours (a glaze's, a picture's)
/// are kept. In place; positions do not change.
void to_high_contrast(std::vector<Item>& items);

/// The replacement for `color`; its alpha is kept.
Color in_high_contrast(Color color);

}  // namespace onggi::view
