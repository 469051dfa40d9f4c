#pragma once

#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// A frame's items for whoever needs more contrast: each colour of the palette by its darker
/// neighbour, so that words have at least 7:1 on what they stand on (WCAG 2.2, 1.4.6), lines and
/// borders heavier, and the guides' halos solid. Opacity is kept otherwise, and so is a colour that
/// is not the palette's (a glaze's, a picture's). In place; where things stand does not change.
void to_high_contrast(std::vector<Item>& items);

/// The colour that `color` becomes; its alpha is kept.
Color in_high_contrast(Color color);

}  // namespace onggi::view
