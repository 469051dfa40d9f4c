#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/displacements.h"
#include "engine/clay/wall_side.h"

namespace onggi::effects {

/// Moves the blocks `run` of a face of row `j` by `by` metres an element (stride() floats, read in
/// the run only): positive as a press does, inwards outside and outwards inside; negative back. The
/// other face goes along with the share `along` (0..1) of the area that this one gives, as in
/// Yielding::along, and where the wall would be too thin. Held to the clay's limits; the area goes
/// into Clay::areas(), which there must be. Marks dirty. Floor rows have no inside. No allocation.
void move_face(Clay& clay, WallSide side, int j, BlockRun run, const float* by,
               double along) noexcept;

/// Below this, metres, nothing moves: see press_rows.h.
inline constexpr float kLeastMove = 8e-8f;

}  // namespace onggi::effects
