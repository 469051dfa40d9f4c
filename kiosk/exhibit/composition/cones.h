#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/math/vec.h"

namespace onggi::exhibit {

/// A zone of a pot's outline on the cone that fits it best: the line for which the sum of the
/// squared distances of the zone's points is least. x: radius, y: height, m.
struct Cone {
  std::size_t first = 0, last = 0;  ///< Points of the outline; zones share their ends.
  Vec2 at, along;                   ///< A point of the line, and its direction, towards `last`.
  double error = 0.0;               ///< The largest distance of a point from the line, m.
};

/// Divides `outline` (3 points or more, evenly spaced, from the foot up) into the fewest zones
/// whose cones all lie within `tolerance` m, `most` zones at most; of such divisions, that with the
/// least largest error. Allocates; O(points^3), 20 ms for 200.
std::vector<Cone> cones_of(std::span<const Vec2> outline, double tolerance, int most);

/// `points` points at even ways along `outline`. Allocates.
std::vector<Vec2> evenly_along(std::span<const Vec2> outline, std::size_t points);

}  // namespace onggi::exhibit
