#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::surface_dial {

/// The state of a dial after its last reports.
struct State {
  bool pressed = false;
  std::int64_t turned = 0;  ///< Counts since the first report, clockwise positive.
  friend bool operator==(const State&, const State&) = default;
};

/// Reads one report into `state`: 01; a byte with the button in the lowest bit and a touch in the
/// next; 16 signed bits, the turn since the last report. Further bytes (its position on a screen,
/// its width) are ignored. The format is the device's own descriptor. Pure.
ReportResult read(Report report, State& state) noexcept;

/// Counts in a full turn, from the first 16 bits of feature report 01; 3600, a dial's default, if
/// `feature` does not hold them. 1..3600. Pure.
int counts_a_turn(Report feature) noexcept;

/// Output for `pulses` short buzzes, 1..10. Pure.
std::array<std::uint8_t, 5> buzz(int pulses) noexcept;

}  // namespace onggi::device::surface_dial
