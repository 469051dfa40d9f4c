#pragma once

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// The best estimate of the line that a mesh is turned about, without a direction yet.
struct FoundAxis {
  Vec3 origin;
  Vec3 direction{0, 1, 0};  ///< Unit.
  double cost = 1.0;        ///< 0 = every slice a circle about it, 1 = none is.
};

/// Tries the file's axes, the principal axes and the axis that the surface's normals meet best
/// (Pottmann and Randrup 1998), judges each by how far slices across it are circles about one
/// centre, and refines the best. Handles and spouts do not disturb it while most of each slice's
/// circle is free. `mesh` must have an extent and finite positions. Allocates.
FoundAxis find_axis(const TriangleMesh& mesh);

/// The axis along `direction` (a unit vector), where the circles across it have their centres.
FoundAxis axis_along(const TriangleMesh& mesh, Vec3 direction);

/// The median number of surfaces that a ray meets from the middle of `mesh` outwards, level in the
/// file's axes: 2 in a vessel with an inside, hundreds in a heap of loose triangles. O(triangles).
int surfaces_met(const TriangleMesh& mesh);

/// The circle on which most of `points` lie: by least median of a fixed set of triples, then
/// weighted least squares. `support` is the share of points within `tolerance` of it.
struct FittedCircle {
  Vec2 centre;
  double radius = 0.0;
  double support = 0.0;
};
FittedCircle fit_circle(std::span<const Vec2> points, double tolerance);

}  // namespace onggi::extraction
