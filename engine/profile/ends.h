#pragma once

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// The extent of a vessel along its axis, in the heights of a Slicer's frame.
struct BodyEnds {
  double bottom = 0.0, top = 0.0;  ///< Equal where no slice is a circle.
  double size = 0.0;               ///< Largest radius that half of a circle agrees on.
  double roughness = 0.0;          ///< Deviation of the skin from itself next door, frame units.
  bool facing_known = true;        ///< Its surfaces have a known outside.
};

/// A vessel ends where most of its circle ends, not at the highest splinter or handle. On a rough
/// surface the foot is the middle of the flat end, not the lowest bump. O(triangles). Allocates.
BodyEnds find_ends(const Slicer& slicer, RayCrossings& rays);

}  // namespace onggi::extraction
