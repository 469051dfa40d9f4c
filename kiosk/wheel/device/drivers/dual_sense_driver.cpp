#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/portable.h"
#include "kiosk/wheel/device/codecs/dual_sense.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kBetween = 10 * kMs;  // the motors are no faster, and Bluetooth is shared
constexpr std::int64_t kTap = 40 * kMs;      // length of the vibration at a first touch
constexpr std::uint8_t kTapStrength = 160;
constexpr double kStrongest = 200.0;
constexpr double kFullForce = 3.0;  // N at full vibration
constexpr double kDegree = portable::kPi / 180.0;
constexpr double kStillTurn = 3.0 * kDegree;          // rad/s; a held hand is never stiller
constexpr double kGyro = 2000.0 / 32768.0 * kDegree;  // rad/s for one uncalibrated count

double stick(std::uint8_t value) { return std::clamp((value - 127.5) / 127.5, -1.0, 1.0); }

double turning(std::int16_t rate) {
  return std::fabs(rate * kGyro) < kStillTurn ? 0.0 : rate * kGyro;
}

std::uint32_t buttons_of(std::uint32_t raw) {
  using namespace dual_sense;
  constexpr std::pair<std::uint32_t, std::uint32_t> kMeaning[] = {
      {kCross, kEnter},  {kOptions, kEnter}, {kCircle, kGoBack}, {kTriangle, kSide},
      {kSquare, kWater}, {kR1, kFaster},     {kL1, kSlower}};
  // The pad's eight directions, clockwise from up.
  constexpr std::uint32_t kPad[] = {kUp,   kUp | kRight,  kRight, kDown | kRight,
                                    kDown, kDown | kLeft, kLeft,  kUp | kLeft};
  std::uint32_t buttons = (raw & 15) < 8 ? kPad[raw & 15] : 0;
  for (const auto& [bit, meaning] : kMeaning)
    if ((raw & bit) != 0) buttons |= meaning;
  return buttons;
}

/// A game controller: the left stick moves the tool in the plane of the picture, the right one
/// towards and away from the visitor, and tilting turns the tool. It vibrates as hard as the clay
/// pushes.
class DualSenseDriver final : public Driver {
 public:
  explicit DualSenseDriver(bool bluetooth)
      : bus_(bluetooth ? dual_sense::Bus::bluetooth : dual_sense::Bus::usb) {}
  bool begin(HidPort& port) override {
    // By Bluetooth it sends only ten bytes until its calibration is read.
    std::array<std::uint8_t, 64> calibration{};
    port.feature(0x05, calibration);
    return true;
  }
  ReportResult take(Report report, DeviceSample& sample) noexcept override {
    const ReportResult heard = dual_sense::read(report, bus_, state_);
    if (heard != ReportResult::news) return heard;
    sample.push = {stick(state_.left[0]), -stick(state_.left[1]), stick(state_.right[1])};
    sample.turning = {turning(state_.turn[0]), turning(state_.turn[1]), turning(state_.turn[2])};
    sample.buttons = buttons_of(state_.buttons);
    return heard;
  }
  Report say(const DriverOutput& saying) noexcept override {
    if (saying.wish.contact && !std::exchange(touching_, saying.wish.contact))
      touched_ns_ = saying.now_ns;
    touching_ = saying.wish.contact;
    const double share = std::clamp(saying.wish.strength / kFullForce, 0.0, 1.0);
    const auto slow =
        static_cast<std::uint8_t>(saying.wish.contact ? std::lround(kStrongest * share) : 0);
    const bool tap = touching_ && saying.now_ns - touched_ns_ < kTap;
    const std::uint8_t quick = tap ? kTapStrength : std::uint8_t{0};
    // Small changes are not felt, but a full stop is.
    const bool still = slow == 0 && quick == 0;
    const bool same = quick == quick_ && (still ? slow_ == 0 : std::abs(slow - slow_) < 4);
    if (same || (!still && saying.now_ns - said_ns_ < kBetween)) return {};
    slow_ = slow;
    quick_ = quick;
    said_ns_ = saying.now_ns;
    out_ = dual_sense::rumble(bus_, slow_, quick_, sequence_);
    sequence_ = static_cast<std::uint8_t>((sequence_ + 1) & 15);
    return out_.report();
  }
  void end(HidPort& port) noexcept override {
    port.write(dual_sense::rumble(bus_, 0, 0, sequence_).report());
  }

 private:
  dual_sense::Bus bus_;
  dual_sense::State state_;
  dual_sense::Output out_;
  std::uint8_t slow_ = 0, quick_ = 0, sequence_ = 0;
  bool touching_ = false;
  std::int64_t said_ns_ = 0, touched_ns_ = 0;
};

}  // namespace

std::unique_ptr<Driver> make_dual_sense(bool bluetooth) {
  return std::make_unique<DualSenseDriver>(bluetooth);
}

}  // namespace onggi::device
