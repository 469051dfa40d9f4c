#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/row_kernels.h"

namespace onggi::effects {

/// How far a face of a hollow row may be moved, and the one behind it with it, with the share
/// `along` (0..1) of the area that the first gives: as in Yielding::along, and where the wall would
/// be too thin. Within the clay's limits.
row_kernels::FaceMove limits_of(const Clay& clay, WallSide side, double along) noexcept;
/// The same of row `j`, of a clay that has areas; false where it has no such face (floor rows have
/// no inside), or gives no way.
bool may_move(const Clay& clay, WallSide side, int j, double along,
              row_kernels::FaceMove& how) noexcept;
/// Row `j` was moved: tells the clay's areas, and marks it dirty. No allocation.
void was_moved(Clay& clay, int j, const row_kernels::FaceMoved& moved) noexcept;

/// Below this, metres, nothing moves: see press_rows.h.
inline constexpr float kLeastMove = 8e-8f;

}  // namespace onggi::effects
