#pragma once

#include "engine/math/vec.h"

namespace onggi {

/// The direction of `a`, of length 1. `a` is not 0.
inline Vec2 unit(Vec2 a) { return a * (1.0 / length(a)); }
inline Vec3 unit(Vec3 a) { return a * (1.0 / length(a)); }

}  // namespace onggi
