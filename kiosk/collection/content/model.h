#pragma once

#include <cstddef>
#include <vector>

#include "kiosk/collection/content/drawing.h"

namespace onggi::content {

/// The vessel of `drawing`, turned about the y axis in 96 steps. The outline is thinned to within
/// 0.04 % of the vessel's size and 18 degrees of turn a link: some 14,000 triangles, so that a
/// whole shelf opens in a moment. Watertight, metres. Allocates.
TriangleMesh turned(const Drawing& drawing);

/// turned() as the GLB that `onggi vessel make` writes: the same drawing gives the same bytes.
std::vector<std::byte> make_glb(const Drawing& drawing);

}  // namespace onggi::content
