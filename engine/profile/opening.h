#pragma once

#include "engine/profile/slices.h"

namespace onggi::extraction {

/// The view along the axis into one end of a vessel.
struct EndView {
  double openness = 0.0;  ///< Mean depth seen within the end's circle / height, 0..1.
  double through = 0.0;   ///< Share of that circle with a free view through.
  double behind = 0.0;    ///< Share in which a surface is seen from its back.
  /// Distance from the end to the deepest visible surface, frame units; the whole height if the
  /// view is free.
  /// looks through.
  double floor = 0.0;
};

/// Looks into the circle of `radius` about the axis, from above (`from_top`) or from below, between
/// the heights `bottom` and `top`. O(triangles). Allocates.
EndView look_into(const Slicer& slicer, double bottom, double top, double radius, bool from_top);

/// The hollow on the axis, by looks along it: the longest stretch of air that stands on a surface
/// which looks up. Heights of the frame; equal where there is none. A lid may close it.
struct Hollow {
  double floor = 0.0, ceiling = 0.0;
};

/// Looks along the axis within `radius` of it, from `bottom` to `top`. Needs surfaces that know
/// their outside. O(triangles). Allocates.
Hollow find_hollow(const Slicer& slicer, double bottom, double top, double radius);

}  // namespace onggi::extraction
