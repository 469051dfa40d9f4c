#pragma once

#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// A frame's items as they stand on a dark screen: pale words, and each colour of the palette by
/// one that is seen there, so that words have at least 7:1 on the dark and what can be touched
/// 4.5:1. Opacity is kept, and so is a colour that is not the palette's. The dark lies below them
/// all, `width` by `height` pixels. In place; where things stand does not change.
void to_dark(std::vector<Item>& items, int width, int height);

/// The colour that `color` becomes; its alpha is kept.
Color in_the_dark(Color color);

/// What they stand on.
inline constexpr Color kDark{0.078f, 0.071f, 0.063f, 1.0f};

}  // namespace onggi::view
