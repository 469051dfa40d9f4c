#pragma once

#include "kiosk/wheel/device/codecs/polhem.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

/// Polhem and WoodenHaptics: converts counts to a position and a force to currents. Not tested on
/// hardware. The firmware stops the motors 0.5 s after the last output.
class PolhemDriver final : public Driver {
 public:
  explicit PolhemDriver(const ArmDef& arm) : arm_(arm) {}
  /// Any Teensy has its numbers, so it must answer like an arm to a report without current.
  bool begin(HidPort& port) override;
  ReportResult take(Report report, DeviceSample& sample) noexcept override;
  Report say(const DriverOutput& saying) noexcept override;
  void end(HidPort& port) noexcept override;

 private:
  ArmDef arm_;
  ArmAngles at_{};
  bool asks_ = false;  ///< It asks for calibration.
  std::array<std::uint8_t, polhem::kOutputSize> bytes_{};
};

}  // namespace onggi::device
