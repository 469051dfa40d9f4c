#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/row_kernels.h"

namespace onggi::effects {

/// Limits for moving a face of a hollow row. The other face follows with the share `along` (0..1)
/// of the area that the first gives (Yielding::along), and where the wall would be too thin. Within
/// the clay's limits.
row_kernels::FaceMove limits_of(const Clay& clay, WallSide side, double along) noexcept;
/// The same for row `j` of a clay with areas. False if the row has no such face (floor rows have no
/// inside) or does not yield.
bool may_move(const Clay& clay, WallSide side, int j, double along,
              row_kernels::FaceMove& how) noexcept;
/// Call after row `j` was moved: updates the clay's areas and marks the row dirty. No allocation.
void was_moved(Clay& clay, int j, const row_kernels::FaceMoved& moved) noexcept;

/// A smaller move counts as none, m: see kSnap in press_lanes.h.
inline constexpr float kLeastMove = 8e-8f;

}  // namespace onggi::effects
