#pragma once

#include <cstdint>

namespace onggi {

/// The shape of a tool in the clay and on the screen, by its ToolPlace and ToolSize.
enum class BodyKind : std::uint8_t {
  ball,      ///< `radius` round `at`.
  capsule,   ///< `radius` round the line from `at`, `length` along.
  box,       ///< Round `at`: `length` along, `thickness` across, and 2 `radius` the third way.
  cylinder,  ///< Round `at`: `radius`, and `thickness` across, which is its axis.
  wire,      ///< `length` along, round `at`: it presses nothing, and cuts the pot free (wire.h).
};

}  // namespace onggi
