#include <cstdio>

#include "kiosk/wheel/device/codecs/onggi_hid.h"
#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

using onggi_hid::Mode;

namespace {

constexpr std::int64_t kMillisecond = 1'000'000;
constexpr std::int64_t kOffAgain = 50 * kMillisecond;  // repeated in case one was lost
constexpr std::int64_t kArmAgain = 5 * kMillisecond;
constexpr std::uint16_t kBehind = 4;     // outputs that may be in transit
constexpr std::uint16_t kPatience = 12;  // unanswered outputs until it counts as deaf

/// A home-built force device, kiosk/docs/onggi-hid.md.
class OnggiHidDriver final : public Driver {
 public:
  /// Accepts the device if it answers feature 03 as version 1 does. Sends off, which starts the
  /// count.
  bool begin(HidPort& port) override {
    std::array<std::uint8_t, 64> bytes{};
    const int size = port.feature(onggi_hid::kFeatureId, bytes);
    if (size < 0 || static_cast<std::size_t>(size) > bytes.size()) return false;
    if (onggi_hid::read_feature(Report(bytes).first(static_cast<std::size_t>(size)), feature_) !=
        ReportResult::news)
      return false;
    return feature_.version == 1 && port.write(put({}, 0));
  }
  ReportResult take(Report report, DeviceSample& sample) noexcept override {
    onggi_hid::Input input;
    const ReportResult heard = onggi_hid::read(report, input);
    if (heard != ReportResult::news) return heard;
    if (heard_ && !onggi_hid::newer(input.sequence, input_.sequence)) return ReportResult::nothing;
    heard_ = true;
    input_ = input;
    if (static_cast<std::uint16_t>(sequence_ - input.echo) <= kBehind) unanswered_ = 0;
    sample.has_place = true;
    sample.place = input.position;
    sample.buttons = (input.buttons & 1) != 0 ? kClutch : 0u;
    if ((input.buttons & 2) != 0) sample.buttons |= kSide;
    if ((input.buttons & 4) != 0) sample.buttons |= kEnter;
    sample.held = (input.flags & onggi_hid::kHeld) != 0;
    constexpr std::uint8_t kReady = onggi_hid::kArmed | onggi_hid::kPowered;
    sample.armed = (input.flags & kReady) == kReady;
    return heard;
  }
  Report say(const DriverOutput& saying) noexcept override {
    if (!saying.may_push) {
      if (mode_ == Mode::off && saying.now_ns - said_ns_ < kOffAgain) return {};
      return put({}, saying.now_ns);
    }
    onggi_hid::Output out;
    out.cap = saying.cap;
    out.damping = saying.damping;
    if ((input_.flags & onggi_hid::kArmed) == 0) {
      if (mode_ == Mode::arm && saying.now_ns - said_ns_ < kArmAgain) return {};
      out.mode = Mode::arm;
      return put(out, saying.now_ns);
    }
    out.mode = Mode::force;
    out.force = saying.force;
    return put(out, saying.now_ns);
  }
  void end(HidPort& port) noexcept override { port.write(put({}, said_ns_)); }
  bool feels_hand() const noexcept override { return (input_.flags & onggi_hid::kHasSensor) != 0; }
  bool deaf() const noexcept override { return unanswered_ > kPatience; }
  std::string says() const override {
    char text[96];
    std::snprintf(text, sizeof text, "%.1f N, %.0f x %.0f x %.0f mm, firmware %d.%d",
                  feature_.max_force, (feature_.most.x - feature_.least.x) * 1e3,
                  (feature_.most.y - feature_.least.y) * 1e3,
                  (feature_.most.z - feature_.least.z) * 1e3, feature_.firmware >> 8,
                  feature_.firmware & 0xff);
    return text;
  }
  std::optional<double> greatest_force() const noexcept override { return feature_.max_force; }

 private:
  Report put(const onggi_hid::Output& output, std::int64_t now_ns) noexcept {
    onggi_hid::Output out = output;
    out.sequence = ++sequence_;
    if (unanswered_ < 0xffff) ++unanswered_;
    mode_ = out.mode;
    said_ns_ = now_ns;
    bytes_ = onggi_hid::write(out);
    return bytes_;
  }

  onggi_hid::Feature feature_;
  onggi_hid::Input input_;
  bool heard_ = false;            ///< An input has arrived.
  std::uint16_t sequence_ = 0;    ///< Of the last output.
  std::uint16_t unanswered_ = 0;  ///< Outputs since an input echoed one of the newest.
  onggi_hid::Mode mode_ = onggi_hid::Mode::off;
  std::int64_t said_ns_ = 0;
  std::array<std::uint8_t, onggi_hid::kOutputSize> bytes_{};
};

}  // namespace

std::unique_ptr<Driver> make_onggi_hid() { return std::make_unique<OnggiHidDriver>(); }

}  // namespace onggi::device
