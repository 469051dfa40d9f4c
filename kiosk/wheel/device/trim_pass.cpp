#include "kiosk/wheel/device/trim_pass.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr int kHeights = 64;     // from the lowest to the highest position of the tool's middle
constexpr double kLowest = 0.2;  // share of its radius: half of it stays clear of the wheel head
constexpr double kTrimLook = 0.001;                     // m
constexpr double kTrimClear = 0.005, kTrimAway = 0.02;  // m off the clay, m/s there
constexpr double kTrimUp = 0.06;                        // m/s, clear
constexpr double kEnough = 0.0008;                      // m
constexpr double kSpared = 0.001;                       // m

double lowest_of(double radius) { return kLowest * radius; }
}  // namespace

template <class Face>
double TrimPass::centre(double height, const Face& face) const {
  double best = 0;
  for (double up = -radius_; up <= radius_; up += kTrimLook) {
    if (height + up < 0) continue;
    best = std::max(best, face(height + up) + std::sqrt(radius_ * radius_ - up * up));
  }
  return best;
}

bool TrimPass::left_to_do(const ClayView& clay, const Profile& target) const {
  for (double h = 0.001; h < top_; h += 0.001) {
    const double over = clay.radius_at(h, WallSide::outside);
    if (over - target.outer_at(h) > kEnough &&
        over + radius_ - centre(std::max(h, lowest_of(radius_)), [&](double at) {
          return target.outer_at(at);
        }) > kEnough)
      return true;
  }
  return false;
}

void TrimPass::next_pass(const ClayView& clay, const Profile& target) {
  if (passes_ == kMostPasses || !left_to_do(clay, target)) {
    stage_ = Stage::off;
    return;
  }
  ++passes_;
  for (int n = 0; n < kHeights; ++n) {
    const double h = lowest_of(radius_) + n * (top_ - lowest_of(radius_)) / (kHeights - 1);
    const double touch =
        centre(h, [&](double at) { return clay.radius_at(at, WallSide::outside); });
    const double want = centre(h, [&](double at) { return target.outer_at(at); });
    // Stay clear of the target's own clay: a loop that should only touch still takes a little each
    // time.
    const double over = touch - want;
    const double taken = over > kEnough ? over : over + (over / kEnough - 1) * kSpared;
    was_[n] = touch - std::clamp(taken, -kSpared, kDeep);
  }
  height_ = top_;
  clear_ = kTrimClear;
  stage_ = Stage::setting;
}

void TrimPass::begin(const ClayView& clay, const Profile& target) {
  passes_ = 0;
  top_ = std::min(clay.floor_top() + kAbove, 0.5 * clay.rim_height());
  next_pass(clay, target);
  follow(clay, target, 0);
}

void TrimPass::follow(const ClayView& clay, const Profile& target, double dt) {
  if (stage_ == Stage::off || clay.rows() == 0) return;
  const double low = lowest_of(radius_);
  if (stage_ == Stage::setting) {
    clear_ = std::max(0.0, clear_ - kTrimAway * dt);
    if (clear_ == 0) stage_ = Stage::cutting;
  } else if (stage_ == Stage::cutting) {
    height_ = std::max(low, height_ - kDown * dt);
    if (height_ == low) stage_ = Stage::leaving;
  } else if (stage_ == Stage::leaving) {
    clear_ = std::min(kTrimClear, clear_ + kTrimAway * dt);
    if (clear_ == kTrimClear) stage_ = Stage::rising;
  } else {
    // Go along the foot, because a bowl's wall hangs over the straight way up.
    height_ = std::min(top_, height_ + kTrimUp * dt);
    if (height_ == top_) next_pass(clay, target);
  }
  const double place = (height_ - low) / (top_ - low) * (kHeights - 1);
  const int below = std::clamp(static_cast<int>(place), 0, kHeights - 2);
  const double share = place - below;
  at_ = clear_ + was_[below] + share * (was_[below + 1] - was_[below]);
}

HandInput TrimPass::input(Vec3 right) const {
  HandInput hand;
  hand.active = stage_ != Stage::off;
  hand.side = SideWish::outside;
  hand.tool = tool_;
  hand.position = {right.x * at_, height_, right.z * at_};
  return hand;
}

}  // namespace onggi::device
