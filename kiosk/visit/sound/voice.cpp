#include "kiosk/visit/sound/voice.h"

#include <algorithm>

#include "engine/math/portable.h"

namespace onggi::sound {

Glide::Glide(double seconds) noexcept : pace_(-portable::expm1(-1.0 / (seconds * kRate))) {}

void Band::tune(double hz, double q) noexcept {
  const double x = portable::kPi * std::clamp(hz, 20.0, 15000.0) / kRate;
  const double g = portable::sin(x) / portable::sin(0.5 * portable::kPi - x);
  damping_ = 1.0 / std::clamp(q, 0.3, 20.0);
  a1_ = 1.0 / (1.0 + g * (g + damping_));
  a2_ = g * a1_;
  a3_ = g * a2_;
}

}  // namespace onggi::sound
