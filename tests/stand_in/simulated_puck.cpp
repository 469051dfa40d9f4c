#include "tests/stand_in/simulated_puck.h"

#include <algorithm>
#include <cmath>

#include "kiosk/wheel/device/codecs/space_mouse.h"

namespace onggi::stand_in {

namespace {

constexpr long kEvery = 8;          // ms between reports
constexpr double kClear = 0.030;    // m further out than the strokes that it goes between
constexpr long kWakes = 5000;       // ms before a stroke that the hand comes to the puck
constexpr long kBefore = 350;       // ms before a stroke that it comes to the clay
constexpr double kNear = 0.0006;    // m: there
constexpr double kReaction = 0.03;  // s in which it corrects what it sees,
constexpr long kAhead = 42;         // ms that it therefore looks ahead, reports and all

/// How far to push for this share of the full speed: what HidHand makes of a push, inverted.
double push_for(double share, double dead) {
  const double size = std::min(1.0, std::fabs(share));
  if (size < 1e-4) return 0.0;
  return std::copysign(dead + (1.0 - dead) * 0.5 * (std::sqrt(1.0 + 8.0 * size) - 1.0), share);
}

double share_of(double push, double dead) {
  const double size = std::fabs(push);
  if (size <= dead) return 0.0;
  const double s = std::min(1.0, (size - dead) / (1.0 - dead));
  return std::copysign(0.5 * s * (1.0 + s), push);
}

Vec3 outwards(Vec3 at, double by) {
  const double out = axis_distance(at);
  return {at.x * (out + by) / out, at.y, at.z * (out + by) / out};
}

}  // namespace

device::HidListing SimulatedPuck::listing() const {
  return {"",
          0x256f,
          static_cast<std::uint16_t>(reports_ == Reports::split ? 0xc62e : 0xc635),
          1,
          8,
          false,
          "SpaceMouse (simulated)",
          "1"};
}

/// While the track is down, a little ahead on it; between strokes out, along, and in again.
Vec3 SimulatedPuck::goal() const {
  const TrackPoint now = track_.at(ms_);
  if (now.active) return track_.at(ms_ + kAhead).at;
  const long down = track_.next_down(ms_);
  if (down < 0) return outwards(now.at, kClear);
  const Vec3 next = track_.at(down).at;
  if (down - ms_ < kBefore) return next;
  const Vec3 clear = outwards(next, kClear);
  // Out first, at the height where it is.
  if (axis_distance(tool_) < axis_distance(clear) - 0.003) return outwards(tool_, 0.02);
  return clear;
}

void SimulatedPuck::push() {
  const long down = track_.next_down(ms_);
  const bool here = down >= 0 && down - ms_ < kWakes;
  const Vec3 gap = here ? goal() - tool_ : Vec3{};
  Vec3 speed = (1.0 / kReaction) * gap;
  if (!track_.at(ms_).active && length(gap) < kNear) speed = {};
  const Vec3 share = (1.0 / def_.speed) * speed;
  const auto count = [&](double value) {
    return static_cast<int>(std::lround(push_for(value, def_.dead) * device::space_mouse::kFull));
  };
  // Its own z is down, and its y towards the visitor.
  counts_ = {count(share.x), count(share.z), -count(share.y)};
  const auto back = [&](int value) {
    return def_.speed * share_of(double(value) / device::space_mouse::kFull, def_.dead);
  };
  speed_ = {back(counts_[0]), -back(counts_[2]), back(counts_[1])};
}

std::optional<Bytes> SimulatedPuck::tick() {
  ++ms_;
  tool_ += 1e-3 * speed_;
  rested_ = speed_ == Vec3{} ? rested_ + 1 : 0;
  if (rested_ > 3000) tool_ = def_.home;
  std::optional<Bytes> out;
  const auto put = [](Bytes& bytes, const std::array<int, 3>& v) {
    for (const int value : v) {
      bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
      bytes.push_back(static_cast<std::uint8_t>(value >> 8 & 0xff));
    }
  };
  if (reports_ == Reports::split && second_half_) {
    second_half_ = false;
    out = Bytes{2};
    put(*out, {0, 0, 0});
  } else if (ms_ % kEvery == 0 && !track_.empty()) {
    push();
    const bool rest = counts_ == std::array<int, 3>{};
    // A puck at rest says so once and then nothing.
    if (rest && told_rest_) return std::nullopt;
    told_rest_ = rest;
    out = Bytes{1};
    put(*out, counts_);
    if (reports_ == Reports::combined) put(*out, {0, 0, 0});
    second_half_ = reports_ == Reports::split;
  }
  return out;
}

bool SimulatedPuck::take(const Bytes& report) {
  if (report.size() != 2 || report[0] != 4) return false;
  lit_ = report[1] == 1;
  return true;
}

}  // namespace onggi::stand_in
