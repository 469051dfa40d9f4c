#include "engine/force/blow_pulse.h"

#include "engine/math/portable.h"

namespace onggi::force {

void BlowPulse::begin(double force, Vec3 out) noexcept {
  *this = {};
  if (!(force > 0.0)) return;
  peak_ = kMost * force / (force + kHalf);
  out_ = out;
}

// It swells and fades as sin^2, so that no guard of a device cuts it: 590 N/s at most.
Vec3 BlowPulse::step(Vec3 way, double seconds) noexcept {
  if (!any()) return {};
  taken_ -= dot(last_, way);
  since_ += seconds;
  if (taken_ < 0.0 || since_ >= kSeconds) {
    release();
    return {};
  }
  const double s = portable::sin(portable::kPi * since_ / kSeconds);
  last_ = peak_ * s * s * out_;
  return last_;
}

}  // namespace onggi::force
