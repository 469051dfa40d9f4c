#pragma once

#include <cstdint>

#include "engine/clay/wall_side.h"

namespace onggi {

/// Where a tool works, or would work while it is clear: beside the wall, on top of it, or on the
/// inside floor (and then perhaps on the wall's inner face too).
/// within (and then perhaps on the wall's inner face too).
enum class Place : std::uint8_t { outside, inside, rim, floor };

constexpr Place beside(WallSide side) {
  return side == WallSide::outside ? Place::outside : Place::inside;
}

/// The place of a tool that is clear of the clay, by position: inside if it is nearer the axis than
/// the middle of the wall at its height.
/// the axis than the middle of the wall at its height.
enum class SideWish : std::uint8_t { by_position, outside, inside };

}  // namespace onggi
