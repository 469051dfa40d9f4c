#include <algorithm>
#include <utility>

#include "engine/math/portable.h"
#include "kiosk/wheel/device/codecs/surface_dial.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

namespace {

/// A dial for the wheel: turning it changes the wheel's speed, a click is Enter.
class SurfaceDialDriver final : public Driver {
 public:
  bool begin(HidPort& port) override {
    // Another program may have set a coarser step, which the dial remembers while it sleeps.
    std::array<std::uint8_t, 16> feature{};
    const int size = port.feature(0x01, feature);
    const Report said = Report(feature).first(static_cast<std::size_t>(std::clamp(size, 0, 16)));
    count_ = 2.0 * portable::kPi / surface_dial::counts_a_turn(said);
    return true;
  }
  ReportResult take(Report report, DeviceSample& sample) noexcept override {
    const ReportResult heard = surface_dial::read(report, state_);
    if (heard != ReportResult::news) return heard;
    sample.dial = static_cast<double>(state_.turned) * count_;
    sample.buttons = state_.pressed ? kEnter : 0u;
    return heard;
  }
  Report say(const DriverOutput& saying) noexcept override {
    if (std::exchange(buzzed_, saying.wish.buzzes) == saying.wish.buzzes) return {};
    bytes_ = surface_dial::buzz(1);
    return bytes_;
  }
  void end(HidPort&) noexcept override {}

 private:
  surface_dial::State state_;
  double count_ = 0.0;  ///< rad
  std::uint32_t buzzed_ = 0;
  std::array<std::uint8_t, 5> bytes_{};
};

}  // namespace

std::unique_ptr<Driver> make_surface_dial() { return std::make_unique<SurfaceDialDriver>(); }

}  // namespace onggi::device
