#pragma once

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// The line a mesh is turned about, as near as it can be told. No sense of up yet.
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

/// How many surfaces a ray meets from the middle of `mesh` outwards, level in the file's axes, as a
/// median: 2 in a vessel with an inside, hundreds in a heap of loose triangles. O(triangles).
int surfaces_met(const TriangleMesh& mesh);

/// The circle that most of `points` lie on: by least median of a fixed set of triples, then
/// weighted least squares. `support` is the share of points within `tolerance` of it.
struct FittedCircle {
  Vec2 centre;
  double radius = 0.0;
  double support = 0.0;
};
FittedCircle fit_circle(std::span<const Vec2> points, double tolerance);

}  // namespace onggi::extraction
