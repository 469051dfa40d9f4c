#pragma once

#include <cstdint>
#include <vector>

#include "engine/profile/profile.h"

namespace onggi::view {

/// Shape of a clay grid, as the renderer needs it.
struct GridShape {
  int rows = 0, sectors = 0;
  double height = 0;        ///< Metres over all rows.
  double floor_height = 0;  ///< Metres: top of the floor.
  double lump_outer = 0;    ///< Metres: radii shown until rows come; 0 shows nothing until then.
  double lump_inner = 0;
  friend bool operator==(const GridShape&, const GridShape&) = default;
};

/// One changed row of the clay: `sectors` outer radii, then `sectors` inner radii, metres.
struct RowUpdate {
  int row = 0;
  std::vector<float> radii;
};

/// The rows of a Profile turned about its axis, for pictures of vessels. Allocates.
std::vector<RowUpdate> rows_of(const Profile& profile, const GridShape& shape);

}  // namespace onggi::view
