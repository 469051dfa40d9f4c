#include "engine/math/lowpass.h"

#include <cmath>

#include "engine/math/portable.h"

namespace onggi {

Lowpass::Lowpass(double cutoff, double rate) {
  const double angle = portable::kPi * cutoff / rate;
  const double k = portable::sin(angle) / portable::cos(angle);
  const double norm = 1.0 / (1.0 + std::sqrt(2.0) * k + k * k);
  b0_ = k * k * norm;
  a1_ = 2.0 * (k * k - 1.0) * norm;
  a2_ = (1.0 - std::sqrt(2.0) * k + k * k) * norm;
}

double Lowpass::filter(double in) {
  const double out = b0_ * (in + 2.0 * x1_ + x2_) - a1_ * y1_ - a2_ * y2_;
  x2_ = x1_;
  x1_ = in;
  y2_ = y1_;
  y1_ = out;
  return out;
}

}  // namespace onggi
