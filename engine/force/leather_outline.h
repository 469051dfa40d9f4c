#pragma once

#include <vector>

#include "engine/math/vec.h"

namespace onggi::force {

/// Where a place is at a leather-hard wall.
struct NearWall {
  double along = 0.0;  ///< Of the nearest place, from the outline's beginning, m.
  double depth = 0.0;  ///< In the clay, m; below 0: so far off it.
  Vec3 out;            ///< Unit, out of the clay: how the depth falls quickest. Studio frame.
};

/// The wall of a leather-hard pot, a surface of revolution, for the 1 kHz side: it is asked how
/// deep a tool is. The depth is the exact distance to the outline, so that a push along `out` is
/// that of a spring, and no closed path gains by it.
class LeatherOutline {
 public:
  /// Corners by radius (x, m, >= 0) and height (y, m): from the foot up the outside, over the lip,
  /// down the inside. `begins`: `along` of the first, m; `apart`: how much
  /// farther along each one is than the one before, m, 0: as far as it is. Corners that are not
  /// finite, or lie on the one before, are left out. With fewer than two it has no wall. Allocates.
  explicit LeatherOutline(const std::vector<Vec2>& corners, double begins = 0.0,
                          double apart = 0.0);

  bool stands() const { return corners_.size() > 1; }
  /// The nearest wall; depth is far below 0 if there is none. No allocation; O(corners).
  NearWall near(Vec3 at) const noexcept;
  /// The nearest one no farther along than `reach` (m) from `along`, so that a tool that is pushed
  /// deep stays at the face that it touches.
  NearWall near(Vec3 at, double along, double reach) const noexcept;

 private:
  struct Corner {
    Vec2 at;
    double along = 0.0;
  };
  std::vector<Corner> corners_;
};

}  // namespace onggi::force
