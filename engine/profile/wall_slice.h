#pragma once

#include <vector>

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// What one slice of a vessel says: radii on which most of its circle agrees.
struct WallSlice {
  double outer = 0.0;   ///< 0 where too little of the circle was there.
  double inner = 0.0;   ///< 0 where the slice is solid or its inside was not seen.
  double spread = 0.0;  ///< Standard deviation of the outer radii that agree.
  int present = 0;      ///< Rays that met a surface...
  int masked = 0;       ///< ...and of those, what stands off: handle, spout, damage.
};

/// Reads one outline cut about the origin of its plane. `size` is the vessel's largest radius, for
/// tolerances. `rays` is scratch. `facing_known` says that the mesh's surfaces know their outside.
WallSlice read_wall(const std::vector<CutSegment>& outline, RayCrossings& rays, double size,
                    bool facing_known);

}  // namespace onggi::extraction
