#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vec.h"

namespace onggi {

/// One height of a vessel of revolution.
struct ProfilePoint {
  double height = 0.0;  ///< Above the standing surface, metres, rising strictly along a Profile.
  double outer = 0.0;   ///< Outer radius, metres, > 0.
  double inner = 0.0;   ///< Inner radius, metres, 0 <= inner < outer; 0 where the body is solid.
};

/// The source of a Profile's inner radii.
enum class InnerWall { measured, inferred, none };

/// Outer and inner radius over height: the common form of a vessel, a target and a thrown pot.
/// Heights start at 0 and rise strictly; between points both radii are linear. At least two points.
struct Profile {
  std::vector<ProfilePoint> points;
  InnerWall inner_wall = InnerWall::measured;
  /// RMS distance of the outer face from a circle about the axis, over all heights, metres. 0 where
  /// it is not known, as of a scan.
  double out_of_round = 0.0;

  /// Metres from the standing surface to the rim.
  double height() const { return points.empty() ? 0.0 : points.back().height; }
  /// Largest outer radius, metres.
  double max_radius() const;
  /// Outer radius at `h` (clamped to the ends), metres. O(log n), no allocation.
  double outer_at(double h) const;
  /// Inner radius at `h` (clamped to the ends), metres. O(log n), no allocation.
  double inner_at(double h) const;
  /// Height of the inside floor: the lowest height at which inner > 0. Metres.
  double floor_height() const;
};

/// The same shape times `factor` in every direction. factor > 0.
Profile scaled(const Profile& p, double factor);

/// The same shape sampled at `n` (>= 2) even heights from 0 to its rim.
Profile resampled(const Profile& p, int n);

/// Checks the invariants of Profile. `name` goes into the Problem's `where`.
Result<void> validate(const Profile& p, const std::string& name);

}  // namespace onggi
