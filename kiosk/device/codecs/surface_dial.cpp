#include "kiosk/device/codecs/surface_dial.h"

#include <algorithm>

namespace onggi::device::surface_dial {

Heard read(Report report, State& state) noexcept {
  if (report.empty()) return Heard::broken;
  if (report[0] != 0x01) return Heard::nothing;
  if (report.size() < 3) return Heard::broken;
  const std::uint16_t word = u16_at(report, 1);
  state.pressed = (word & 1) != 0;
  // Fifteen bits with a sign: shifted in from the left, as sixteen.
  state.turned += static_cast<std::int16_t>(word & 0xfffe) / 2;
  return Heard::news;
}

std::array<std::uint8_t, 5> buzz(int pulses) noexcept {
  return {0x01, static_cast<std::uint8_t>(std::clamp(pulses, 1, 10)), 0x03, 0x00, 0x00};
}

}  // namespace onggi::device::surface_dial
