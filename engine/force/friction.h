#pragma once

#include "engine/math/vec.h"

namespace onggi {

/// Friction of clay that slides along a tool: Coulomb's, made smooth near rest,
/// F = -mu N v / sqrt(v^2 + eps^2), with `slip` the tool's velocity less the clay's (m/s), taken
/// along the surface whose normal is `reaction`. `normal` is the sum of the elements' normal
/// forces, N. Silent without slip; never larger than mu N.
inline Vec3 friction_force(Vec3 reaction, double normal, Vec3 slip, double mu, double eps) {
  const double square = dot(reaction, reaction);
  if (square > 0.0) slip = slip - (dot(slip, reaction) / square) * reaction;
  return (-mu * normal / std::sqrt(dot(slip, slip) + eps * eps)) * slip;
}

/// Velocity of clay at `at` on a wheel that turns by `speed` (rad/s, from x towards z), m/s.
inline Vec3 clay_velocity(Vec3 at, double speed) { return {-speed * at.z, 0.0, speed * at.x}; }

}  // namespace onggi
