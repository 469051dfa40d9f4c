#pragma once

#include "kiosk/wheel/device/codecs/surface_dial.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

/// A dial for the wheel: turning it changes the wheel's speed, a click is Enter.
class SurfaceDialDriver final : public Driver {
 public:
  bool begin(HidPort& port) override;
  ReportResult take(Report report, DeviceSample& sample) noexcept override;
  Report say(const DriverOutput& saying) noexcept override;
  void end(HidPort&) noexcept override {}

 private:
  surface_dial::State state_;
  double count_ = 0.0;  ///< rad
  std::uint32_t buzzed_ = 0;
  std::array<std::uint8_t, 5> bytes_{};
};

}  // namespace onggi::device
