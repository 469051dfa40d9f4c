#pragma once

#include "engine/contact/bodies/bounds.h"
#include "engine/math/vec.h"

namespace onggi::body {

/// All points within `radius` of `middle`. Clay frame, metres.
struct Ball {
  Vec3 middle;
  double radius = 0;  ///< > 0.

  /// A ball is its own support ball.
  Ball support(Vec3 /*towards*/) const noexcept { return *this; }
  Ball within(Vec3 /*towards*/) const noexcept { return *this; }
};

/// Radius of a sphere's cross-section `dy` from its centre; -1 if there is none. Factored to avoid
/// cancellation near the poles.
double cross_section(double radius, double dy) noexcept;

/// A ball at `point`, moved so that its farthest point `towards` (unit) lies `farthest` from the
/// origin. Support points are given as balls, because clay presses on a ball.
Ball support_ball(Vec3 point, double farthest, double radius, Vec3 towards) noexcept;
/// -1..1: which end of a straight part along `axis` lies farther `towards`. Between -1 and 1 if the
/// part is nearly square to `towards`, so that the support point does not jump.
double support_end(Vec3 axis, Vec3 towards) noexcept;
/// Cosine below which a part counts as square to a direction.
inline constexpr double kSquareTo = 0.1;
/// Largest ball that represents an edge, m: a fingertip.
inline constexpr double kBluntestEdge = 0.008;

}  // namespace onggi::body
