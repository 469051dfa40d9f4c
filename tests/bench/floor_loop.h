#pragma once

#include <cstdint>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::bench {

/// The least that a press must do: the same rows and blocks of eight as press(), from each element
/// its ray and its face, one square root, and where it is pressed the other face and both stored.
/// No force, no depth, no limits, no sweep. `decay` of a press is left. Gives the elements visited.
std::int64_t floor_loop(Clay& clay, WallSide side, Vec3 at, double radius, double decay) noexcept;

}  // namespace onggi::bench
