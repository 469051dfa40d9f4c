#include "kiosk/wheel/device/codecs/space_mouse.h"

#include <algorithm>

namespace onggi::device::space_mouse {

namespace {

constexpr std::size_t kSplit = 7, kCombined = 13;

std::array<std::int16_t, 3> axes_at(Report report, std::size_t at) {
  std::array<std::int16_t, 3> axes{};
  for (std::size_t n = 0; n < 3; ++n)
    axes[n] = static_cast<std::int16_t>(std::clamp<int>(i16_at(report, at + 2 * n), -kFull, kFull));
  return axes;
}

}  // namespace

ReportResult read(Report report, State& state) noexcept {
  if (report.empty()) return ReportResult::broken;
  switch (report[0]) {
    case 0x01:
      if (report.size() != kSplit && report.size() != kCombined) return ReportResult::broken;
      state.push = axes_at(report, 1);
      if (report.size() == kCombined) state.twist = axes_at(report, 7);
      return ReportResult::news;
    case 0x02:
      if (report.size() != kSplit) return ReportResult::broken;
      state.twist = axes_at(report, 1);
      return ReportResult::news;
    case 0x03: {
      if (report.size() < 2) return ReportResult::broken;
      std::uint32_t buttons = 0;
      for (std::size_t n = 1; n < std::min<std::size_t>(report.size(), 5); ++n)
        buttons |= static_cast<std::uint32_t>(report[n]) << 8 * (n - 1);
      state.buttons = buttons;
      return ReportResult::news;
    }
    case 0x17:
      if (report.size() < 2) return ReportResult::broken;
      state.battery = std::min<std::uint8_t>(report[1], 100);
      return ReportResult::news;
    default:
      return ReportResult::nothing;
  }
}

std::array<std::uint8_t, 2> light(bool on) noexcept {
  return {0x04, static_cast<std::uint8_t>(on ? 1 : 0)};
}

}  // namespace onggi::device::space_mouse
