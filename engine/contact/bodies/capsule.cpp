#include "engine/contact/bodies/capsule.h"

#include <algorithm>
#include <cmath>

namespace onggi::body {

Heights Capsule::heights() const noexcept {
  return {std::min(tip.y, end().y) - radius, std::max(tip.y, end().y) + radius};
}

Hull Capsule::hull() const noexcept {
  Hull hull;
  hull.middle[0] = tip;
  hull.middle[1] = end();
  hull.count = 2;
  hull.radius = radius;
  return hull;
}

// The capsule's sections lie within those of an endless rod.
Approach Capsule::approach() const noexcept {
  Approach of;
  if (std::fabs(axis.y) < kAskew) return of;
  of.level = tip.y;
  of.at = {tip.x, tip.z};
  of.lean = {axis.x / axis.y, axis.z / axis.y};
  of.round = radius / std::fabs(axis.y);
  return of;
}

Outline Capsule::outline(double y) const noexcept {
  // The part of its line within `radius` of the plane.
  double from = 0.0;
  double to = length;
  double nearest = 0.0;
  if (std::fabs(axis.y) > 1e-9) {
    const double a = (y - radius - tip.y) / axis.y;
    const double b = (y + radius - tip.y) / axis.y;
    from = std::clamp(std::min(a, b), 0.0, length);
    to = std::clamp(std::max(a, b), 0.0, length);
    nearest = std::clamp((y - tip.y) / axis.y, 0.0, length);
  }
  const double round = cross_section(radius, tip.y + nearest * axis.y - y);
  const Vec3 middle = tip + 0.5 * (from + to) * axis;
  const Vec3 half = 0.5 * (to - from) * axis;
  Outline out;
  out.x = static_cast<float>(middle.x);
  out.z = static_cast<float>(middle.z);
  out.ux = static_cast<float>(half.x);
  out.uz = static_cast<float>(half.z);
  out.round = static_cast<float>(round);
  if (to > from) add_oval(out, tip, axis, radius, y);
  return out;
}

Ball Capsule::support(Vec3 towards) const noexcept {
  const double part = 0.5 + 0.5 * support_end(axis, towards);
  const double farthest = dot(tip, towards) + std::max(0.0, length * dot(axis, towards)) + radius;
  return support_ball(tip + (part * length) * axis, farthest, radius, towards);
}

Ball Capsule::within(Vec3 towards) const noexcept {
  return {tip + ((0.5 + 0.5 * support_end(axis, towards)) * length) * axis, radius};
}

Capsule::Section Capsule::section(double y) const noexcept {
  const Vec3 far = end();
  return {rod_section(tip, axis, radius, y), static_cast<float>(length), static_cast<float>(far.x),
          static_cast<float>(far.y - y), static_cast<float>(far.z)};
}

}  // namespace onggi::body
