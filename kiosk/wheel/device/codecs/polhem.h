#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::polhem {

/// Polhem and WoodenHaptics, the Teensy's raw HID. Not verified on hardware: written after what the
/// open firmware and library of Forsslund Systems send.

struct Input {
  std::array<std::int16_t, 6> encoder{};  ///< Counts: three of the arm, three of the stylus.
  std::int16_t info = 0;                  ///< 1: it asks to be calibrated.
  friend bool operator==(const Input&, const Input&) = default;
};

inline constexpr std::size_t kInputSize = 64, kOutputSize = 65;

/// Reads 64 bytes that have no id. Pure.
Heard read(Report report, Input& input) noexcept;

/// Motor currents, milliamperes: all brought down by one share where one is beyond `most`
/// (0..32767), so that the force keeps its direction; none where one is no number. Pure.
std::array<std::uint8_t, kOutputSize> currents(const std::array<double, 3>& milliamperes,
                                               double most) noexcept;
/// Command 1: "you stand at these counts." No current flows. Pure.
std::array<std::uint8_t, kOutputSize> calibrate(const std::array<std::int16_t, 3>& counts) noexcept;

}  // namespace onggi::device::polhem
