#pragma once

#include "engine/math/vec.h"

namespace onggi::view {

/// Direction to the middle of the studio's one window, studio frame, not of unit length. It is at
/// the visitor's left, and shadows fall to the right; if words are there it is at the right, so
/// that shadows fall away from words on every screen.
constexpr Vec3 window_at(bool right) { return {right ? 0.86 : -0.86, 0.60, 0.36}; }

}  // namespace onggi::view
