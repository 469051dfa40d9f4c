#include "engine/force/coupling.h"

#include <algorithm>
#include <cmath>

namespace onggi::force {

namespace {

constexpr double kStill = 1e-9;  // m: below what an encoder counts

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

Vec3 Coupling::felt_stretch(const CouplingLimits& limits) noexcept {
  past_[static_cast<std::size_t>(next_)] = {hand_, stretch_};
  next_ = (next_ + 1) % kMost;
  held_ = std::min(held_ + 1, kMost);
  const int ticks = static_cast<int>(std::min(kMean / seconds_ + 0.5, double{kMost}));
  const int count = std::clamp(ticks, 1, held_);
  // In this order of sums a still hand feels its spring to the last digit.
  Vec3 sum;
  for (int n = 1; n <= count; ++n) {
    const Past& past = past_[static_cast<std::size_t>((next_ + kMost - n) % kMost)];
    sum += (past.hand - hand_) + past.stretch;
  }
  Vec3 mean{sum.x / count, sum.y / count, sum.z / count};
  // A mean is late by half its length. A steady tool leads it by that; else the hand would feel a
  // damper that is not the clay's.
  const Vec3 place = hand_ + mean;
  ahead_ = held_ == 1 ? Vec3{} : (kSlow / (kSlow + seconds_)) * (ahead_ + place - mean_);
  mean_ = place;
  if (dot(ahead_, ahead_) < kStill * kStill) ahead_ = {};
  mean += (0.5 * (count - 1) * seconds_ / kSlow) * ahead_;
  Vec3 along;
  if (const double strength = length(touch_.push); strength > 0.0) {
    const Vec3 normal = (1.0 / strength) * touch_.push;
    along = dot(mean, normal) * normal;
  }
  // A sliding hand is ahead of the mean. Friction must not grow by that.
  return no_longer_than(along + no_longer_than(mean - along, touch_.grip / limits.stiffness),
                        limits.max_force / limits.stiffness);
}

Vec3 Coupling::tool(Vec3 hand, double seconds, const CouplingLimits& limits) noexcept {
  seconds_ = seconds;
  const Vec3 way = hand - hand_;
  hand_ = hand;
  if (length(touch_.push) > 0.0 || touch_.grip > 0.0) {
    const double strength = length(touch_.push);
    // Implicit Euler, with what clay gives way in the coming tick; else the tool would follow late.
    if (touch_.relaxation > 0.0)
      push_ *= touch_.relaxation / (touch_.relaxation + gives_ * seconds);
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
  const double met = length(touch.push);
  if (met > 0.0 && push_ > 0.0) {
    const double share = (met - push_) / push_ * touch.relaxation / (kLearns + seconds_);
    gives_ = std::clamp(gives_ - share, 0.0, 1.0);
  } else {
    gives_ = 1.0;
  }
  touch_ = touch;
  push_ = met;
  if (push_ > 0.0 || touch.grip > 0.0) {
    balance(limits);
    return limits.stiffness * felt_stretch(limits);
  }
  held_ = 0;
  return limits.stiffness * stretch_;
}

}  // namespace onggi::force
