#pragma once

#include "kiosk/wheel/device/codecs/onggi_hid.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

/// A home-built force device, kiosk/docs/onggi-hid.md.
class OnggiHidDriver final : public Driver {
 public:
  /// It must answer feature 03 as version 1 does. Sends off, which starts the count.
  bool begin(HidPort& port) override;
  ReportResult take(Report report, DeviceSample& sample) noexcept override;
  Report say(const DriverOutput& saying) noexcept override;
  void end(HidPort& port) noexcept override;
  bool feels_hand() const noexcept override { return (input_.flags & onggi_hid::kHasSensor) != 0; }
  bool deaf() const noexcept override;
  std::string says() const override;
  std::optional<double> greatest_force() const noexcept override { return feature_.max_force; }
  const onggi_hid::Feature& feature() const { return feature_; }

 private:
  Report put(const onggi_hid::Output& output, std::int64_t now_ns) noexcept;

  onggi_hid::Feature feature_;
  onggi_hid::Input input_;
  bool heard_ = false;            ///< An input has arrived.
  std::uint16_t sequence_ = 0;    ///< Of the last output.
  std::uint16_t unanswered_ = 0;  ///< Outputs since an input echoed one of the newest.
  onggi_hid::Mode mode_ = onggi_hid::Mode::off;
  std::int64_t said_ns_ = 0;
  std::array<std::uint8_t, onggi_hid::kOutputSize> bytes_{};
};

}  // namespace onggi::device
