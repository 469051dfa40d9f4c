#pragma once

#include <vector>

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// The result of one slice of a vessel: radii that most of its circle agrees on.
struct WallSlice {
  double outer = 0.0;  ///< 0 if too little of the circle is present.
  double inner = 0.0;  ///< Of the hollow; 0 where the slice is solid or its inside was not seen.
  /// Only one wall lies between inner and outer: no skirt, collar or lid with air behind it.
  bool one_wall = true;
  double spread = 0.0;  ///< Standard deviation of the outer radii that agree.
  int present = 0;      ///< Rays that met a surface,
  int masked = 0;       ///< those of them with handle, spout or damage,
  int within = 0;       ///< and those of them inside the circle.
  Vec2 centre;          ///< Of the surface near the circle, masked or not.
  Vec2 oval;  ///< Half of how much longer than wide it is, at twice the angle of its length.
};

/// Reads one outline cut about the origin of its plane. `size` is the vessel's largest radius, for
/// tolerances. `rays` is scratch. `facing_known` says that the mesh's surfaces know their outside.
WallSlice read_wall(std::span<const CutSegment> outline, RayCrossings& rays, double size,
                    bool facing_known);

/// The same at each of `heights` (rising).
std::vector<WallSlice> read_walls(const Slicer& slicer, std::span<const double> heights,
                                  RayCrossings& rays, double size, bool facing_known);

}  // namespace onggi::extraction
