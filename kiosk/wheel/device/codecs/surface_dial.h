#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::surface_dial {

/// A dial as its reports have it so far.
struct State {
  bool pressed = false;
  std::int64_t turned = 0;  ///< Counts since the first report, clockwise positive.
  friend bool operator==(const State&, const State&) = default;
};

/// Takes one report into `state`: 01; a byte with the button in the lowest bit and a touch in the
/// next; 16 bits with a sign, the turn since the last report. Further bytes (where it stands on a
/// screen, how wide it is) are left. As the device's own descriptor has it. Pure.
Heard read(Report report, State& state) noexcept;

/// Counts that a whole turn has, as feature report 01 says in its first 16 bits; 3600, what a dial
/// wakes up with, where `feature` says nothing of it. 1..3600. Pure.
int counts_a_turn(Report feature) noexcept;

/// `pulses` short buzzes, 1..10: what to write. Pure.
std::array<std::uint8_t, 5> buzz(int pulses) noexcept;

}  // namespace onggi::device::surface_dial
