#pragma once

#include "kiosk/wheel/device/codecs/dual_sense.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

/// A game controller: the left stick moves the tool in the plane of the picture, the right one
/// towards and away from the visitor, and tilting turns the tool. It vibrates as hard as the clay
/// pushes.
class DualSenseDriver final : public Driver {
 public:
  explicit DualSenseDriver(bool bluetooth)
      : bus_(bluetooth ? dual_sense::Bus::bluetooth : dual_sense::Bus::usb) {}
  bool begin(HidPort& port) override;
  ReportResult take(Report report, DeviceSample& sample) noexcept override;
  Report say(const DriverOutput& saying) noexcept override;
  void end(HidPort& port) noexcept override;

 private:
  dual_sense::Bus bus_;
  dual_sense::State state_;
  dual_sense::Output out_;
  std::uint8_t slow_ = 0, quick_ = 0, sequence_ = 0;
  bool touching_ = false;
  std::int64_t said_ns_ = 0, touched_ns_ = 0;
};

}  // namespace onggi::device
