#include "engine/contact/bodies/ball.h"

#include <algorithm>
#include <cmath>

namespace onggi::body {

double cross_section(double radius, double dy) noexcept {
  const double off = std::fabs(dy);
  return off < radius ? std::sqrt((radius - off) * (radius + off)) : -1.0;
}

Ball support_ball(Vec3 point, double farthest, double radius, Vec3 towards) noexcept {
  return {point + (farthest - radius - dot(point, towards)) * towards, radius};
}

double support_end(Vec3 axis, Vec3 towards) noexcept {
  return std::clamp(dot(axis, towards) / kSquareTo, -1.0, 1.0);
}

}  // namespace onggi::body
