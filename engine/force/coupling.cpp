#include "engine/force/coupling.h"

#include <algorithm>
#include <cmath>

namespace onggi::force {

namespace {

Vec3 no_longer_than(Vec3 v, double most) {
  const double long_is = length(v);
  return long_is > most ? (most / long_is) * v : v;
}

}  // namespace

void Coupling::balance(const CouplingLimits& limits) noexcept {
  const double strength = length(touch_.push);
  Vec3 across = stretch_;
  Vec3 along;
  if (strength > 0.0) {
    const Vec3 normal = (1.0 / strength) * touch_.push;
    double out = dot(stretch_, normal);
    across = stretch_ - out * normal;
    const double step = (push_ - limits.stiffness * out) / (limits.stiffness + touch_.stiffness);
    out += step;
    push_ = std::max(0.0, push_ - touch_.stiffness * step);
    along = out * normal;
  }
  stretch_ = no_longer_than(along + no_longer_than(across, touch_.grip / limits.stiffness),
                            limits.max_force / limits.stiffness);
}

Vec3 Coupling::tool(Vec3 hand, double seconds, const CouplingLimits& limits) noexcept {
  if (!known_) hand_ = hand;
  known_ = true;
  const Vec3 way = hand - hand_;
  hand_ = hand;
  if (length(touch_.push) > 0.0 || touch_.grip > 0.0) {
    const double strength = length(touch_.push);
    // Implicit Euler: what clay gives way in the tick to come, or the tool would follow it late.
    if (touch_.relaxation > 0.0) push_ *= touch_.relaxation / (touch_.relaxation + seconds);
    Vec3 carried = seconds * touch_.clay;
    if (strength > 0.0) {
      const Vec3 normal = (1.0 / strength) * touch_.push;
      carried = carried - dot(carried, normal) * normal;
    }
    stretch_ = stretch_ + carried - way;
    balance(limits);
  } else {
    const double is = length(stretch_);
    const double left = is * kReturnTime / (kReturnTime + seconds);
    stretch_ = no_longer_than(stretch_, std::max(left, is - kReturn * seconds));
  }
  return hand_ + stretch_;
}

Vec3 Coupling::feel(const Touch& touch, const CouplingLimits& limits) noexcept {
  if (!is_finite(touch.push) || !is_finite(touch.clay) ||
      !std::isfinite(touch.stiffness + touch.relaxation) || !std::isfinite(touch.grip)) {
    release();
    return {};
  }
  touch_ = touch;
  push_ = length(touch.push);
  if (push_ > 0.0 || touch.grip > 0.0) balance(limits);
  return limits.stiffness * stretch_;
}

}  // namespace onggi::force
