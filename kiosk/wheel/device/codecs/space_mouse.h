#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::space_mouse {

/// The state of a puck on springs after its last reports. Some devices send translation and
/// rotation in two reports, so one half may be a report older.
struct State {
  std::array<std::int16_t, 3> push{};   ///< x right, y towards the visitor, z down; -350..350.
  std::array<std::int16_t, 3> twist{};  ///< About the same, right-handed; -350..350.
  std::uint32_t buttons = 0;            ///< A bit a button.
  std::uint8_t battery = 0xff;          ///< Percent; 0xff: not reported yet.
  friend bool operator==(const State&, const State&) = default;
};

inline constexpr int kFull = 350;  ///< Value at full deflection.

/// Reads one report into `state`. By id and length: 01 of 7 bytes is translation, 01 of 13 both, 02
/// of 7 rotation, 03 buttons, 17 (hex) battery. Values beyond kFull are limited to it. Pure.
ReportResult read(Report report, State& state) noexcept;

/// Output for the ring of light. Pure.
std::array<std::uint8_t, 2> light(bool on) noexcept;

}  // namespace onggi::device::space_mouse
