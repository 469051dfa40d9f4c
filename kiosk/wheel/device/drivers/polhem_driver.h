#pragma once

#include "kiosk/wheel/device/codecs/polhem.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

/// Polhem and WoodenHaptics: counts to a place, a force to currents, both made here. Not verified
/// on hardware. The firmware cuts the motors 0.5 s after the last word.
class PolhemDriver final : public Driver {
 public:
  explicit PolhemDriver(const ArmDef& arm) : arm_(arm) {}
  /// Its numbers are any Teensy's: it must answer to a report without current as an arm does.
  bool begin(HidPort& port) override;
  Heard take(Report report, DeviceSample& sample) noexcept override;
  Report say(const Saying& saying) noexcept override;
  void end(HidPort& port) noexcept override;

 private:
  ArmDef arm_;
  ArmAngles at_{};
  bool asks_ = false;  ///< To be told where it stands.
  std::array<std::uint8_t, polhem::kOutputSize> bytes_{};
};

}  // namespace onggi::device
