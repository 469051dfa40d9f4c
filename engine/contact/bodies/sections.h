#pragma once

#include "engine/math/vec.h"

namespace onggi::body {

/// The cut of a body with the level plane at a row's height, in closed form for flat faces and
/// straight rods, as floats for kernels (interval_lanes.h has the formulas).

/// Between two planes.
struct SlabSection {
  float nx, ny, nz;  ///< Unit normal.
  float half;        ///< Half the distance between the planes, m.
  float off;   ///< Distance of the axis point at the row's height from the middle plane, along the
               ///< normal, m.
  bool asked;  ///< False if the row lies wholly between the planes.
};
SlabSection slab_section(Vec3 middle, Vec3 normal, double half, double y) noexcept;

/// Within `radius` of a straight line through a point `middle`.
struct RodSection {
  float radius;
  float mx, my, mz;  ///< The point, from the row's height.
  float ax, ay, az;  ///< Unit direction of the line.
  float wx, wz;      ///< Of direction x (axis at this height - point).
  float m_along;     ///< (axis at this height - point) . direction
};
RodSection rod_section(Vec3 middle, Vec3 axis, double radius, double y) noexcept;

}  // namespace onggi::body
