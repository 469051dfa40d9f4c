#include "kiosk/wheel/device/codecs/surface_dial.h"

#include <algorithm>

namespace onggi::device::surface_dial {

ReportResult read(Report report, State& state) noexcept {
  if (report.empty()) return ReportResult::broken;
  if (report[0] != 0x01) return ReportResult::nothing;
  if (report.size() < 4) return ReportResult::broken;
  state.pressed = (report[1] & 1) != 0;
  state.turned += i16_at(report, 2);
  return ReportResult::news;
}

int counts_a_turn(Report feature) noexcept {
  constexpr int kWakesUpWith = 3600;
  if (feature.size() < 3 || feature[0] != 0x01) return kWakesUpWith;
  const int counts = u16_at(feature, 1);
  return counts >= 1 && counts <= kWakesUpWith ? counts : kWakesUpWith;
}

std::array<std::uint8_t, 5> buzz(int pulses) noexcept {
  return {0x01, static_cast<std::uint8_t>(std::clamp(pulses, 1, 10)), 0x03, 0x00, 0x00};
}

}  // namespace onggi::device::surface_dial
