#include "engine/effects/walls.h"

#include <algorithm>
#include <cmath>

namespace onggi {

std::span<const EffectField<WallsDef>> WallsDef::fields() {
  static constexpr EffectField<WallsDef> kFields[] = {
      {"support", &WallsDef::support, 0.001, 0.2, "m"},
      {"tear_thickness", &WallsDef::tear_thickness, 0.0, 0.02, "m"},
      {"tear_strain", &WallsDef::tear_strain, 0.0, 10.0, ""},
  };
  return kFields;
}

namespace effects {

double wall_support(const WallsDef& def, Vec3 pressing, Vec3 holding) noexcept {
  // Apart along the wall: up, and round it where the pressing hand is.
  const double radius = axis_distance(pressing);
  const double inward = axis_distance(holding);
  const double both = std::max(radius * inward, 1e-12);
  const double cosine = (pressing.x * holding.x + pressing.z * holding.z) / both;
  // The chord of the angle between: no arc cosine, and the far side is far.
  const double chord = radius * std::sqrt(std::max(2.0 - 2.0 * cosine, 0.0));
  const double up = pressing.y - holding.y;
  const double apart = std::sqrt(up * up + chord * chord) / def.support;
  const double t = std::clamp(1.0 - apart, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace effects
}  // namespace onggi
