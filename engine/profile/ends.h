#pragma once

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// How far along its axis a vessel reaches, in the heights of a Slicer's frame.
struct BodyEnds {
  double bottom = 0.0, top = 0.0;  ///< Equal where no slice is a circle.
  double size = 0.0;               ///< Largest radius on which half of a circle agrees.
  double roughness = 0.0;          ///< Deviation of the skin from itself next door, frame units.
  bool facing_known = true;        ///< Its surfaces know their outside.
};

/// A vessel ends where most of its circle does, not where the highest splinter or handle does. On a
/// rough skin the lowest bump is not the foot: the middle of the flat end is. O(triangles).
/// Allocates.
BodyEnds find_ends(const Slicer& slicer, RayCrossings& rays);

}  // namespace onggi::extraction
