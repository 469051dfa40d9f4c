#pragma once

#include <cstdint>

namespace onggi {

/// Which face of the wall a tool works.
enum class WallSide : std::uint8_t { outside, inside };

constexpr WallSide other(WallSide side) {
  return side == WallSide::outside ? WallSide::inside : WallSide::outside;
}

/// Where a tool that is clear of the clay is to be taken to stand. By position: inside when nearer
/// the axis than the middle of the wall at its height.
enum class SideWish : std::uint8_t { by_position, outside, inside };

}  // namespace onggi
