#pragma once

#include <cstdint>

#include "engine/clay/wall_side.h"

namespace onggi {

/// Where a tool works, or would work if it is clear: beside the wall, on top of it, or on the
/// inside floor. On the floor it may touch the wall's inner face too.
enum class Place : std::uint8_t { outside, inside, rim, floor };

constexpr Place beside(WallSide side) {
  return side == WallSide::outside ? Place::outside : Place::inside;
}

/// The side of a tool that is clear of the clay. by_position: inside if it is nearer the axis than
/// the middle of the wall at its height.
enum class SideWish : std::uint8_t { by_position, outside, inside };

}  // namespace onggi
