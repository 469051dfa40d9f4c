#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::polhem {

/// Polhem and WoodenHaptics, the Teensy's raw HID. Not tested on hardware: it follows the open
/// firmware and library of Forsslund Systems.

struct Input {
  std::array<std::int16_t, 6> encoder{};  ///< Counts: three of the arm, three of the stylus.
  std::int16_t info = 0;                  ///< 1: it asks for calibration.
  friend bool operator==(const Input&, const Input&) = default;
};

inline constexpr std::size_t kInputSize = 64, kOutputSize = 65;

/// Reads 64 bytes without an id. Pure.
ReportResult read(Report report, Input& input) noexcept;

/// Motor currents, milliamperes. If one is beyond `most` (0..32767), all are reduced by the same
/// factor, so that the force keeps its direction. If one is NaN, all are zero. Pure.
std::array<std::uint8_t, kOutputSize> currents(const std::array<double, 3>& milliamperes,
                                               double most) noexcept;
/// Command 1: sets the encoder counts. No current flows. Pure.
std::array<std::uint8_t, kOutputSize> calibrate(const std::array<std::int16_t, 3>& counts) noexcept;

}  // namespace onggi::device::polhem
