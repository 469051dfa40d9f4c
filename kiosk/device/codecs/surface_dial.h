#pragma once

#include <array>
#include <cstdint>

#include "kiosk/device/codecs/wire_bytes.h"

namespace onggi::device::surface_dial {

/// A dial as its reports have it so far.
struct State {
  bool pressed = false;
  std::int64_t turned = 0;  ///< Tenths of a degree since the first report, clockwise positive.
  friend bool operator==(const State&, const State&) = default;
};

/// Takes one report into `state`: 01, then the button in the lowest bit and the turn since the last
/// report in the 15 above it. Further bytes (where it stands on a screen) are left. Pure.
Heard read(Report report, State& state) noexcept;

/// `pulses` short buzzes, 1..10: what to write. Pure.
std::array<std::uint8_t, 5> buzz(int pulses) noexcept;

}  // namespace onggi::device::surface_dial
