#pragma once

#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Converts a frame's items for a dark screen: pale words, and each palette colour becomes one that
/// is visible there, so that words have at least 7:1 on the dark ground and touch targets 4.5:1.
/// Opacity and foreign colours are kept. Adds the dark ground below them, `width` by `height`
/// pixels. In place; positions do not change.
void to_dark(std::vector<Item>& items, int width, int height);

/// The replacement for `color`; its alpha is kept.
Color in_the_dark(Color color);

/// The ground under them.
inline constexpr Color kDark{0.078f, 0.071f, 0.063f, 1.0f};

}  // namespace onggi::view
