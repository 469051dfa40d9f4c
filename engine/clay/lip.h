#pragma once

#include <algorithm>
#include <cmath>

namespace onggi {

/// Radius of the rim's rounded edges, metres. On a thinner wall the lip is half a torus. Its crown
/// is at Clay::rim_height().
inline constexpr double kLipRadius = 0.003;

/// How far the lip lies below its crown at `rho` (inner..outer) from the axis, of a wall from
/// `inner` to `outer`; a solid top (inner 0) has one edge. Metres.
inline double lip_drop(double inner, double outer, double rho) noexcept {
  const double thickness = inner > 0.0 ? outer - inner : 2.0 * outer;
  const double edge = std::min(0.5 * thickness, kLipRadius);
  const double x = edge - (inner > 0.0 ? std::min(rho - inner, outer - rho) : outer - rho);
  return x > 0.0 ? edge - std::sqrt(std::max((edge - x) * (edge + x), 0.0)) : 0.0;
}

}  // namespace onggi
