#pragma once

#include "engine/base/def_field.h"
#include "engine/math/vec.h"

namespace onggi {

/// Clay drags the hand along: Coulomb friction, smoothed near rest.
struct FrictionDef {
  double coefficient = 0.35;  ///< mu when dry, 0..2. Higher: the turning wall pulls harder.
  double wet_factor = 0.3;    ///< mu is multiplied by this when dripping wet, 0..1.
  double slip_speed = 0.01;   ///< eps, m/s, 1e-4..0.1: below this slip, friction fades.

  static constexpr const char* kName = "friction";
  static std::span<const DefField<FrictionDef>> fields();
};

namespace effects {

/// Coefficient of clay of `wetness` 0..1.
double friction_coefficient(const FrictionDef& def, double wetness) noexcept;

/// Friction of clay sliding along a tool: F = -mu N v / sqrt(v^2 + eps^2). `slip`: the tool's
/// velocity minus the clay's (m/s), projected on the surface with normal `reaction`. `normal`: sum
/// of the elements' normal forces, N. Zero without slip; at most mu N. Any thread, no allocation.
Vec3 friction_force(Vec3 reaction, double normal, Vec3 slip, double mu, double eps) noexcept;

/// Velocity of clay at `at` on a wheel that turns by `speed` (rad/s, from x towards z), m/s.
inline Vec3 clay_velocity(Vec3 at, double speed) { return {-speed * at.z, 0.0, speed * at.x}; }

}  // namespace effects
}  // namespace onggi
