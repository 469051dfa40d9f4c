#pragma once

#include "engine/math/vec.h"

namespace onggi::view {

/// Towards the middle of the studio's one window, studio frame, not of unit length: light comes
/// from the visitor's left, and shadows fall to the right on every screen.
inline constexpr Vec3 kWindow{-0.86, 0.60, 0.36};

/// Where on the ground what is at `p` (metres) casts its shadow.
constexpr Vec3 shadow_of(Vec3 p) {
  return {p.x - p.y * kWindow.x / kWindow.y, 0.0, p.z - p.y * kWindow.z / kWindow.y};
}

}  // namespace onggi::view
