#pragma once

namespace onggi {

/// Upward force of a firm, flat stop on a sphere whose lowest point is `depth` (m) below it, N. It
/// is the stiffness (N/m per m^2) times the depth summed over the covered disc, which is the volume
/// of the cap. Rises smoothly from zero, and is weighted by area like the wall.
constexpr double stop_force(double depth, double radius, double stiffness) {
  if (!(depth > 0.0)) return 0.0;
  const double d = depth < 2.0 * radius ? depth : 2.0 * radius;
  constexpr double kPi = 3.14159265358979323846;
  return stiffness * kPi * d * d * (radius - d / 3.0);
}

}  // namespace onggi
