#include "kiosk/wheel/device/rib_pass.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr double kLook = 0.002;  // m between the sampled heights of the wall
constexpr double kMostLean = 1.5;

double outer(const ClayView& clay, double height) {
  return clay.radius_at(std::clamp(height, 0.0, clay.rim_height()), WallSide::outside);
}
}  // namespace

void RibPass::begin(const ClayView& clay) {
  const double half = 0.5 * length_;
  height_ = std::min(half + 0.004, 0.5 * clay.rim_height());
  top_ = std::max(height_, clay.rim_height() - 0.25 * length_);
  clear_ = kClear;
  stage_ = Stage::setting;
  lay(clay);
}

void RibPass::lay(const ClayView& clay) {
  const double span = 0.25 * length_;
  lean_ = std::clamp((outer(clay, height_ + span) - outer(clay, height_ - span)) / (2 * span),
                     -kMostLean, kMostLean);
  const double cosine = 1 / std::sqrt(1 + lean_ * lean_);
  double bears = 0;
  for (double up = -0.5 * length_ * cosine; up <= 0.5 * length_ * cosine; up += kLook)
    if (height_ + up < clay.rim_height() && height_ + up > 0)
      bears = std::max(bears, outer(clay, height_ + up) - lean_ * up);
  // Half its thickness lies across the lean.
  radius_ = bears + 0.5 * thickness_ / cosine + clear_ - kDeep;
}

void RibPass::follow(const ClayView& clay, double dt) {
  if (stage_ == Stage::off || clay.rows() == 0) return;
  if (stage_ == Stage::setting) {
    clear_ = std::max(0.0, clear_ - kAway * dt);
    if (clear_ == 0) stage_ = Stage::rising;
  } else if (stage_ == Stage::rising) {
    height_ = std::min(top_, height_ + kRise * dt);
    if (height_ == top_) stage_ = Stage::leaving;
  } else {
    clear_ += kAway * dt;
    if (clear_ > kClear) stage_ = Stage::off;
  }
  lay(clay);
}

HandInput RibPass::input(Vec3 right) const {
  HandInput hand;
  hand.active = stage_ != Stage::off;
  hand.side = SideWish::outside;
  hand.tool = tool_;
  hand.position = {right.x * radius_, height_, right.z * radius_};
  hand.handle = {right.x * lean_, 1.0, right.z * lean_};
  return hand;
}

}  // namespace onggi::device
