#include <utility>

#include "kiosk/wheel/device/codecs/polhem.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

namespace {
constexpr int kTries = 20;
constexpr int kTryMs = 10;

/// Polhem and WoodenHaptics: converts counts to a position and a force to currents. Not tested on
/// hardware. The firmware stops the motors 0.5 s after the last output.
class PolhemDriver final : public Driver {
 public:
  explicit PolhemDriver(const ArmDef& arm) : arm_(arm) {}
  /// Any Teensy has its numbers, so it must answer like an arm to a report without current.
  bool begin(HidPort& port) override {
    std::array<std::uint8_t, 128> bytes{};
    polhem::Input input;
    for (int n = 0; n < kTries; ++n) {
      // It answers only after an output.
      if (!port.write(polhem::currents({}, 0))) return false;
      const int size = port.read(bytes, kTryMs);
      if (size < 0) return false;
      if (size == 0) continue;
      if (polhem::read(Report(bytes).first(static_cast<std::size_t>(size)), input) !=
          ReportResult::news)
        return false;
      return input.info == 0 || input.info == 1;
    }
    return false;
  }
  ReportResult take(Report report, DeviceSample& sample) noexcept override {
    polhem::Input input;
    const ReportResult heard = polhem::read(report, input);
    if (heard != ReportResult::news) return heard;
    asks_ = input.info == 1;
    at_ = arm_angles(arm_, {input.encoder[0], input.encoder[1], input.encoder[2]});
    sample.has_place = true;
    sample.place = arm_position(arm_, at_);
    // It needs no arming. While it asks for calibration, its position cannot be trusted.
    sample.armed = !asks_;
    return heard;
  }
  Report say(const DriverOutput& saying) noexcept override {
    if (std::exchange(asks_, false)) {
      std::array<std::int16_t, 3> parked{};
      for (std::size_t n = 0; n < 3; ++n) parked[n] = static_cast<std::int16_t>(arm_.parked[n]);
      bytes_ = polhem::calibrate(parked);
      return bytes_;
    }
    const Vec3 force = saying.may_push ? saying.force : Vec3{};
    bytes_ = polhem::currents(arm_currents(arm_, at_, force), arm_.most_milliamperes);
    return bytes_;
  }
  void end(HidPort& port) noexcept override { port.write(polhem::currents({}, 0)); }

 private:
  ArmDef arm_;
  ArmAngles at_{};
  bool asks_ = false;  ///< It asks for calibration.
  std::array<std::uint8_t, polhem::kOutputSize> bytes_{};
};

}  // namespace

std::unique_ptr<Driver> make_polhem(const ArmDef& arm) {
  return std::make_unique<PolhemDriver>(arm);
}

}  // namespace onggi::device
