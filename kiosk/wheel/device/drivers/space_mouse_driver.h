#pragma once

#include "kiosk/wheel/device/codecs/space_mouse.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

/// A puck: its deflection sets the tool's speed. Its light is on while it is in use.
class SpaceMouseDriver final : public Driver {
 public:
  bool begin(HidPort& port) override;
  ReportResult take(Report report, DeviceSample& sample) noexcept override;
  Report say(const DriverOutput&) noexcept override { return {}; }
  void end(HidPort& port) noexcept override;

 private:
  space_mouse::State state_;
};

}  // namespace onggi::device
