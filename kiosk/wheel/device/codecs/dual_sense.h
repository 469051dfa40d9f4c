#pragma once

#include <array>
#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::dual_sense {

/// Bits of State::buttons, in the order of the report's bytes; the direction pad is separate.
enum Button : std::uint32_t {
  kSquare = 1u << 4,
  kCross = 1u << 5,
  kCircle = 1u << 6,
  kTriangle = 1u << 7,
  kL1 = 1u << 8,
  kR1 = 1u << 9,
  kOptions = 1u << 13,
};

struct State {
  std::array<std::uint8_t, 2> left{128, 128};  ///< Stick: x right, y down; 128 is the middle.
  std::array<std::uint8_t, 2> right{128, 128};
  std::array<std::uint8_t, 2> trigger{};  ///< Left, right; 0 free .. 255.
  std::uint8_t sequence = 0;
  std::uint32_t buttons = 0x08;        ///< Bits 0..3: direction pad, 8 is none.
  std::array<std::int16_t, 3> turn{};  ///< Gyroscope, some 1/16 degree a second, uncalibrated.
  std::array<std::int16_t, 3> pull{};  ///< Accelerometer, 1/8192 g, uncalibrated.
  std::uint32_t time = 0;              ///< Thirds of a microsecond, wraps.
  friend bool operator==(const State&, const State&) = default;
};

/// The connection, which decides the format of reports.
enum class Bus : std::uint8_t { usb, bluetooth };

/// Reads one report into `state`: 01 of 64 bytes by cable, 31 (hex) of 78 by Bluetooth, whose
/// CRC-32 is seeded with A1. The short Bluetooth report 01 of 10 bytes is ignored. Pure.
ReportResult read(Report report, Bus bus, State& state) noexcept;

/// An output report and its length.
struct Output {
  std::array<std::uint8_t, 78> bytes{};
  std::size_t size = 0;
  Report report() const { return Report(bytes).first(size); }
};

/// Both motors, 0 off .. 255: the slow one in the left grip, the fast one in the right. `sequence`,
/// 0..15, counts a Bluetooth controller's reports. CRC-32 seeded with A2. Pure.
Output rumble(Bus bus, std::uint8_t slow, std::uint8_t quick, std::uint8_t sequence) noexcept;

}  // namespace onggi::device::dual_sense
