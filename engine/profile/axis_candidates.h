#pragma once

#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::extraction {

/// Axes suggested by the shape: where its normals meet, and its principal axes; none within 0.6
/// degrees of x, y or z. Unit vectors.
std::vector<Vec3> axis_candidates(const TriangleMesh& mesh);

}  // namespace onggi::extraction
