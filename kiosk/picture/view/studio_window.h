#pragma once

#include <cmath>

#include "engine/math/vec.h"

namespace onggi::view {

/// Where the studio's one window is, round the pot's axis, rad: 0 behind the visitor, who has it at
/// the left, below 0, or at the right. It is at the left, and shadows fall to the right; where
/// words are there it is at the right, so that shadows fall away from words on every screen.
inline constexpr double kWindowRight = 1.1743550435764554, kWindowLeft = -kWindowRight;

/// Direction to its middle, studio frame, not of unit length.
inline Vec3 window_at(double window) {
  constexpr double kAway = 0.9323089616645331, kUp = 0.60;
  return {kAway * std::sin(window), kUp, kAway * std::cos(window)};
}

}  // namespace onggi::view
