#pragma once

#include <cstdint>

namespace onggi {

/// The face of the wall that a tool works.
enum class WallSide : std::uint8_t { outside, inside };

constexpr WallSide other(WallSide side) {
  return side == WallSide::outside ? WallSide::inside : WallSide::outside;
}

}  // namespace onggi
