#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::space_mouse {

/// A puck on springs, as its reports have it so far. Split devices send translation and rotation in
/// two reports, so that half of it is a report older.
struct State {
  std::array<std::int16_t, 3> push{};   ///< x right, y towards the visitor, z down; -350..350.
  std::array<std::int16_t, 3> twist{};  ///< About the same, right-handed; -350..350.
  std::uint32_t buttons = 0;            ///< A bit a button.
  std::uint8_t battery = 0xff;          ///< Percent; 0xff: it never said.
  friend bool operator==(const State&, const State&) = default;
};

inline constexpr int kFull = 350;  ///< What a puck pushed as far as it goes reports.

/// Takes one report into `state`. By id and length: 01 of 7 bytes is translation, 01 of 13 both, 02
/// of 7 rotation, 03 buttons, 17 (hex) battery. Figures beyond kFull are taken for it. Pure.
Heard read(Report report, State& state) noexcept;

/// The ring of light: what to write. Pure.
std::array<std::uint8_t, 2> light(bool on) noexcept;

}  // namespace onggi::device::space_mouse
