#pragma once

#include <cstdint>

namespace onggi {

/// The shape of a tool in the clay and on the screen. ToolPlace and ToolSize give its place and
/// size.
enum class BodyKind : std::uint8_t {
  ball,      ///< `radius` round `at`.
  capsule,   ///< `radius` round the line from `at`, `length` along.
  box,       ///< Centred on `at`: `length` along, `thickness` across, and 2 `radius` the third way.
  cylinder,  ///< Centred on `at`: a disc of `radius`, its axis across, `thickness` thick.
  wire,  ///< Centred on `at`, `length` along. It presses nothing; it cuts the pot free (wire.h).
};

}  // namespace onggi
