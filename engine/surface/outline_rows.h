#pragma once

#include <string>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/surface/grid.h"

namespace onggi::surface {

/// Parts of the outline, in their order.
enum class Part { outside, lip, inside, floor };

/// One row of cells on the reference body: the pot as it was when decorating began.
struct Row {
  double height = 0.0, radius = 0.0;  ///< Of its middle, m.
  Part part = Part::outside;
  int wall = 0;   ///< Thickness of clay across the surface, um.
  int width = 0;  ///< Of a cell, nm.
  int area = 0;   ///< Of a cell, um^2, > 0.
};

/// The outline ends this far from the axis: nearer, cells would be slivers. m.
inline constexpr double kLeastRadius = 0.006;
inline constexpr int kMostRows = 8192;  ///< 2 m of outline.

/// The rows of `profile` by arc length: from the foot up the outside, over the flat lip, down the
/// inside, over the floor as far as kLeastRadius. A solid one ends on its top. Allocates. Problem:
/// `profile` is no profile, its outline is longer than kMostRows, or there is no row of it.
Result<std::vector<Row>> outline_of(const Profile& profile, const std::string& name);

}  // namespace onggi::surface
