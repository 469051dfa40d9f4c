#include "engine/force/guard.h"

#include <algorithm>

namespace onggi::force {
namespace {

// `v` shortened to `most`, even if its length overflows.
Vec3 clamped(Vec3 v, double most) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (largest > 1e100) v = (1.0 / largest) * v * 1e100;
  const double long_is = length(v);
  return long_is > most ? (most / long_is) * v : v;
}

}  // namespace

Vec3 Guard::step(Vec3 wanted, double seconds, const GuardLimits& limits, bool& wanted_ok) noexcept {
  wanted_ok = is_finite(wanted);
  if (!wanted_ok) {
    wanted = {};
    release();
  }
  wanted = clamped(wanted, limits.max_force);

  // Engages only once the wanted force is small, then from nothing over engage_time.
  constexpr double kSmall = 0.1;  // of max_force
  armed_ = armed_ || (wanted_ok && length(wanted) <= kSmall * limits.max_force);
  const double before = ramp_;
  if (armed_) ramp_ = std::min(1.0, ramp_ + seconds / limits.engage_time);

  // A tick uses the ramp's mean over it.
  const Vec3 engaged = 0.5 * (before + ramp_) * wanted;
  const Vec3 change = clamped(engaged - force_, limits.max_slew * seconds);
  force_ = clamped(force_ + change, limits.max_force);
  return force_;
}

}  // namespace onggi::force
