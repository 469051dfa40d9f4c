#pragma once

#include <span>
#include <vector>

#include "engine/math/vec.h"
#include "engine/profile/mesh.h"
#include "kiosk/picture/view/image.h"

namespace onggi::drawing {

/// The window of an engraving: metres in the plane z = 0, x to the right and y up.
struct EngravingWindow {
  double left = 0.0, right = 0.1, bottom = 0.0, top = 0.1;
  double pixels_per_metre = 1000.0;
};

/// `mesh` seen from +z without perspective, in grey tones on a transparent ground: lit from the
/// upper left, with a line where the depth breaks or the surface turns sharply. Places further from
/// the y axis than the line `limit` (radius over height, rising) are tinted as left out. Needs no
/// display or GPU. Four samples a pixel. Allocates; any thread.
view::Image engrave(const TriangleMesh& mesh, std::span<const Vec2> limit,
                    const EngravingWindow& window);

}  // namespace onggi::drawing
