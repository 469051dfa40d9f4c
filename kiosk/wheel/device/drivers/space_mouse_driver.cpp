#include "kiosk/wheel/device/drivers/space_mouse_driver.h"

namespace onggi::device {

bool SpaceMouseDriver::begin(HidPort& port) {
  port.write(space_mouse::light(true));  // not every model has a light
  return true;
}

ReportResult SpaceMouseDriver::take(Report report, DeviceSample& sample) noexcept {
  const ReportResult heard = space_mouse::read(report, state_);
  if (heard != ReportResult::news) return heard;
  // The puck's z is down and its y towards the visitor.
  const auto turned = [](const std::array<std::int16_t, 3>& a) {
    constexpr double kShare = 1.0 / space_mouse::kFull;
    return Vec3{a[0] * kShare, -a[2] * kShare, a[1] * kShare};
  };
  sample.push = turned(state_.push);
  sample.twist = turned(state_.twist);
  sample.buttons =
      ((state_.buttons & 1) != 0 ? kSide : 0u) | ((state_.buttons & 2) != 0 ? kEnter : 0u);
  return heard;
}

void SpaceMouseDriver::end(HidPort& port) noexcept { port.write(space_mouse::light(false)); }

}  // namespace onggi::device
