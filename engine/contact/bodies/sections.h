#pragma once

#include "engine/math/vec.h"

namespace onggi::body {

/// The cut of a body with the level plane at a row's height, as floats for kernels. Closed form for
/// flat faces and straight rods (formulas in interval_lanes.h).

/// Between two planes.
struct SlabSection {
  float nx, ny, nz;  ///< Unit normal.
  float half;        ///< Half the distance between the planes, m.
  float off;   ///< Distance from the middle plane to the axis point at the row's height, along the
               ///< normal, m.
  bool asked;  ///< False if the whole row lies between the planes.
};
SlabSection slab_section(Vec3 middle, Vec3 normal, double half, double y) noexcept;

/// Within `radius` of a straight line through a point `middle`.
struct RodSection {
  float radius;
  float mx, my, mz;  ///< The point, relative to the row's height.
  float ax, ay, az;  ///< Unit direction of the line.
  float wx, wz;      ///< direction x (axis at this height - point)
  float m_along;     ///< (axis at this height - point) . direction
};
RodSection rod_section(Vec3 middle, Vec3 axis, double radius, double y) noexcept;

}  // namespace onggi::body
