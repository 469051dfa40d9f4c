#include "engine/effects/friction.h"

#include <cmath>

namespace onggi {

std::span<const DefField<FrictionDef>> FrictionDef::fields() {
  static constexpr DefField<FrictionDef> kFields[] = {
      {"coefficient", &FrictionDef::coefficient, 0.0, 2.0, ""},
      {"wet_factor", &FrictionDef::wet_factor, 0.0, 1.0, ""},
      {"slip_speed", &FrictionDef::slip_speed, 1e-4, 0.1, "m/s"},
  };
  return kFields;
}

namespace effects {

double friction_coefficient(const FrictionDef& def, double wetness) noexcept {
  return def.coefficient * (1.0 + wetness * (def.wet_factor - 1.0));
}

Vec3 friction_force(Vec3 reaction, double normal, Vec3 slip, double mu, double eps) noexcept {
  const double square = dot(reaction, reaction);
  if (square > 0.0) slip = slip - (dot(slip, reaction) / square) * reaction;
  return (-mu * normal / std::sqrt(dot(slip, slip) + eps * eps)) * slip;
}

}  // namespace effects
}  // namespace onggi
