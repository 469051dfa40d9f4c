#include "kiosk/device/drivers/surface_dial_driver.h"

#include <utility>

#include "engine/math/portable.h"

namespace onggi::device {

Heard SurfaceDialDriver::take(Report report, DeviceSample& sample) noexcept {
  const Heard heard = surface_dial::read(report, state_);
  if (heard != Heard::news) return heard;
  sample.dial = static_cast<double>(state_.turned) * portable::kPi / 1800.0;
  sample.buttons = state_.pressed ? kEnter : 0u;
  return heard;
}

Report SurfaceDialDriver::say(const Saying& saying) noexcept {
  if (std::exchange(buzzed_, saying.wish.buzzes) == saying.wish.buzzes) return {};
  bytes_ = surface_dial::buzz(1);
  return bytes_;
}

}  // namespace onggi::device
