#include "kiosk/wheel/device/wall_pass.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

void WallPass::remember(const WallHold& hold, const ClayView& clay) {
  constexpr int kBeside = 4;
  const double rim = clay.rim_height();
  for (std::size_t n = 0; n < kLooks; ++n) {
    const double height = rim * static_cast<double>(n) / (kLooks - 1);
    // Sample as far up as down, so that a leaning wall is measured at the right place.
    const double seen = std::min({kSeen, height, rim - height});
    double sum = 0;
    for (int k = -kBeside; k <= kBeside; ++k) sum += hold.face(clay, height + seen * k / kBeside);
    wall_[n] = {sum / (2 * kBeside + 1),
                height > clay.floor_top() ? WallHold::thickness(clay, height) : 0.0};
  }
}

void WallPass::begin(const WallHold& hold, const ClayView& clay, double height) {
  remember(hold, clay);
  turn_ = at_ = height;
  up_ = backs_ = 0;
  on_ = -kStay;
  asked_ = depth_ = leaving_ = 0;
  eased_ = -1;
  stood_ = {hold.face(clay, height), 0.0};
}

void WallPass::ease_out() {
  leaving_ = depth_;
  eased_ = 0;
}

bool WallPass::out() const {
  constexpr double kNoMark = 0.0005;  // m: a shallower print has no edge
  return eased_ >= std::min(kOut, 2 * std::abs(leaving_)) || std::abs(leaving_) < kNoMark;
}

void WallPass::go(const WallHold& hold, const ClayView& clay, double height,
                  std::optional<double> reach, double dt) {
  const double moved = std::abs(height - at_);
  on_ = std::max(-kStay, on_ + kPressOn * dt - moved);
  at_ = height;
  const double way = height - turn_;
  if (up_ == 0) {
    if (std::abs(way) > kBack) up_ = way > 0 ? 1 : -1;
  } else if (up_ * way < -kBack) {
    up_ = -up_;
    ++backs_;
    remember(hold, clay);
    asked_ = depth_ = 0;
  }
  if (up_ * way > 0 || std::abs(way) > kBack) turn_ = height;
  // Use the share of the height, because a wall that is pulled up takes its marks along.
  const double place = (kLooks - 1) * std::clamp(height / clay.rim_height(), 0.0, 1.0);
  const auto below = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(below);
  const Look &lower = wall_[below], &upper = wall_[std::min(below + 1, kLooks - 1)];
  stood_ = {lower.radius + share * (upper.radius - lower.radius),
            lower.thickness + share * (upper.thickness - lower.thickness)};
  if (eased_ >= 0) {
    eased_ += moved;
    const double left = out() ? 0 : 1 - eased_ / std::min(kOut, 2 * std::abs(leaving_));
    depth_ = leaving_ * left * left * (3 - 2 * left);
    return;
  }
  const double step = kSlope * moved + kDeeper * dt;
  asked_ += std::clamp(within(reach.value_or(stood_.radius)) - stood_.radius - asked_, -step, step);
  depth_ += (asked_ - depth_) * std::min(1.0, moved / kSoftWay + dt / kSoftTime);
}

double WallPass::within(double reach) const {
  const double first = std::clamp(kOfThickness * stood_.thickness, kDeepest, kMost);
  const double most = (backs_ > 0 ? kEvening : first) + std::max(0.0, on_);
  return std::clamp(reach, stood_.radius - most, stood_.radius + most);
}

}  // namespace onggi::device
