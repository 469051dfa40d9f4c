#pragma once

#include <vector>

#include "engine/clay/clay_mesh.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::exhibit {

/// A pot as it is kept: a closed mesh, and its surface at each position.
struct LeanPot {
  TriangleMesh mesh;
  std::vector<view::SkinPoint> skin;
};

/// The same pot with fewer triangles: only the rings and sectors that nobody would miss are left
/// out, so that it looks and prints as before. What is left is exact, its normals too. `skin` has a
/// point for each position. Deterministic. Allocates.
LeanPot lean(const ClayMesh& pot, const std::vector<view::SkinPoint>& skin);

}  // namespace onggi::exhibit
