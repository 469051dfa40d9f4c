#pragma once

#include "engine/math/vec.h"

namespace onggi::view {

/// Towards the middle of the studio's one window, studio frame, not of unit length. It is at the
/// visitor's left, and shadows fall to the right; where words stand there it is at the right, so
/// that shadows fall away from them on every screen.
constexpr Vec3 window_at(bool right) { return {right ? 0.86 : -0.86, 0.60, 0.36}; }

}  // namespace onggi::view
