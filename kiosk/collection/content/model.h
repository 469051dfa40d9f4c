#pragma once

#include <cstddef>
#include <vector>

#include "engine/surface/surface.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/decoration/decoration.h"

namespace onggi::content {

/// The vessel of `drawing`, turned about the y axis in 96 steps. The outline is thinned to within
/// 0.04 % of the vessel's size and 18 degrees of turn a link: some 14,000 triangles, so that a
/// whole shelf opens in a moment. Watertight, metres. Allocates.
TriangleMesh turned(const Drawing& drawing);

/// turned() as the GLB that `onggi vessel make` writes: the same drawing gives the same bytes.
std::vector<std::byte> make_glb(const Drawing& drawing);

/// The vessel of `drawing` at the wheel's size with `decoration` on it; Problems as
/// decoration::decorated(). Allocates; tens of milliseconds.
Result<surface::Surface> decorated(const Drawing& drawing, const decoration::Decoration& decoration,
                                   const std::string& name);

/// make_glb() with the colours of a decoration: `mesh` is turned() with a place for each position.
std::vector<std::byte> make_glb(const Drawing& drawing, const TriangleMesh& mesh,
                                const GlbPicture& picture);

}  // namespace onggi::content
