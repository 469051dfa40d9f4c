#include "kiosk/wheel/device/codecs/space_mouse.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

namespace {

/// A puck: its deflection sets the tool's speed. Its light is on while it is in use.
class SpaceMouseDriver final : public Driver {
 public:
  bool begin(HidPort& port) override {
    port.write(space_mouse::light(true));  // not every model has a light
    return true;
  }
  ReportResult take(Report report, DeviceSample& sample) noexcept override {
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
  Report say(const DriverOutput&) noexcept override { return {}; }
  void end(HidPort& port) noexcept override { port.write(space_mouse::light(false)); }

 private:
  space_mouse::State state_;
};

}  // namespace

std::unique_ptr<Driver> make_space_mouse() { return std::make_unique<SpaceMouseDriver>(); }

}  // namespace onggi::device
