#include "engine/contact/bodies/sections.h"

#include <cmath>

namespace onggi::body {

SlabSection slab_section(Vec3 middle, Vec3 normal, double half, double y) noexcept {
  const double off = normal.y * (y - middle.y) - normal.x * middle.x - normal.z * middle.z;
  // For level planes: off_zero() (interval_lanes.h) lets rays leave them 10 m and more away.
  const bool between = normal.x == 0.0 && normal.z == 0.0 && half - std::fabs(off) > 1e-6;
  return {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z),
          static_cast<float>(half),     static_cast<float>(off),      !between};
}

RodSection rod_section(Vec3 middle, Vec3 axis, double radius, double y) noexcept {
  const Vec3 from{-middle.x, y - middle.y, -middle.z};
  const Vec3 w = cross(axis, from);
  return {static_cast<float>(radius),       static_cast<float>(middle.x),
          static_cast<float>(middle.y - y), static_cast<float>(middle.z),
          static_cast<float>(axis.x),       static_cast<float>(axis.y),
          static_cast<float>(axis.z),       static_cast<float>(w.x),
          static_cast<float>(w.z),          static_cast<float>(dot(from, axis))};
}

}  // namespace onggi::body
