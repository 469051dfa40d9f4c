#include "kiosk/wheel/device/drivers/surface_dial_driver.h"

#include <algorithm>
#include <utility>

#include "engine/math/portable.h"

namespace onggi::device {

bool SurfaceDialDriver::begin(HidPort& port) {
  // Another program may have set a coarser step, which the dial remembers while it sleeps.
  std::array<std::uint8_t, 16> feature{};
  const int size = port.feature(0x01, feature);
  const Report said = Report(feature).first(static_cast<std::size_t>(std::clamp(size, 0, 16)));
  count_ = 2.0 * portable::kPi / surface_dial::counts_a_turn(said);
  return true;
}

ReportResult SurfaceDialDriver::take(Report report, DeviceSample& sample) noexcept {
  const ReportResult heard = surface_dial::read(report, state_);
  if (heard != ReportResult::news) return heard;
  sample.dial = static_cast<double>(state_.turned) * count_;
  sample.buttons = state_.pressed ? kEnter : 0u;
  return heard;
}

Report SurfaceDialDriver::say(const DriverOutput& saying) noexcept {
  if (std::exchange(buzzed_, saying.wish.buzzes) == saying.wish.buzzes) return {};
  bytes_ = surface_dial::buzz(1);
  return bytes_;
}

}  // namespace onggi::device
