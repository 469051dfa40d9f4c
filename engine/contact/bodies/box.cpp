#include "engine/contact/bodies/box.h"

#include <algorithm>
#include <cmath>

namespace onggi::body {

Heights Box::heights() const noexcept {
  double up = 0.0;
  for (std::size_t k = 0; k < 3; ++k) up += half[k] * std::fabs(axis[k].y);
  return {middle.y - up, middle.y + up};
}

Hull Box::hull() const noexcept {
  Hull hull;
  hull.count = 8;
  for (std::size_t n = 0; n < 8; ++n)
    hull.middle[n] = middle + ((n & 1) != 0 ? half[0] : -half[0]) * axis[0] +
                     ((n & 2) != 0 ? half[1] : -half[1]) * axis[1] +
                     ((n & 4) != 0 ? half[2] : -half[2]) * axis[2];
  return hull;
}

Outline Box::outline(double y) const noexcept {
  // Solve for the steepest direction. The plane leaves the other two free, as far as the rest of
  // the block reaches the plane.
  std::size_t steep = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(axis[k].y) > std::fabs(axis[steep].y)) steep = k;
  const double up = y - middle.y;
  double most[3];
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += most[k] = half[k] * std::fabs(axis[k].y);
  Outline out;
  if (std::fabs(up) > sum) {
    out.round = -1.0f;
    return out;
  }
  const Vec3 steepest = axis[steep];
  Vec3 centre = middle + (up / steepest.y) * steepest;
  Vec3 side[2];
  int n = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == steep) continue;
    double low = -half[k];
    double high = half[k];
    const double rise = axis[k].y;
    if (std::fabs(rise) > 1e-9) {
      const double a = (up - (sum - most[k])) / rise;
      const double b = (up + (sum - most[k])) / rise;
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    const Vec3 level = axis[k] - (rise / steepest.y) * steepest;
    centre += 0.5 * (low + high) * level;
    side[n++] = std::max(0.5 * (high - low), 0.0) * level;
  }
  out.x = static_cast<float>(centre.x);
  out.z = static_cast<float>(centre.z);
  out.ux = static_cast<float>(side[0].x);
  out.uz = static_cast<float>(side[0].z);
  out.vx = static_cast<float>(side[1].x);
  out.vz = static_cast<float>(side[1].z);
  return out;
}

Ball Box::support(Vec3 towards) const noexcept {
  Vec3 point = middle;
  double farthest = dot(middle, towards);
  for (std::size_t k = 0; k < 3; ++k) {
    farthest += half[k] * std::fabs(dot(axis[k], towards));
    point += (half[k] * support_end(axis[k], towards)) * axis[k];
  }
  return support_ball(point, farthest, std::min(kBluntestEdge, half[2]), towards);
}

Ball Box::within(Vec3 towards) const noexcept {
  const double radius = std::min({kBluntestEdge, half[0], half[1], half[2]});
  Vec3 at = middle;
  for (std::size_t k = 0; k < 3; ++k)
    at += ((half[k] - radius) * support_end(axis[k], towards)) * axis[k];
  return {at, radius};
}

Box::Section Box::section(double y) const noexcept {
  return {slab_section(middle, axis[0], half[0], y), slab_section(middle, axis[1], half[1], y),
          slab_section(middle, axis[2], half[2], y)};
}

Box::Section Box::section_like(const Section& other, double y) const noexcept {
  return {slab_section(middle, axis[0], half[0], y), other.b, other.c};
}

}  // namespace onggi::body
