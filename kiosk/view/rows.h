#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/clay/lip.h"
#include "engine/profile/profile.h"

namespace onggi::view {

/// Shape of a clay grid, as the renderer needs it. Rows are stacked evenly until they say
/// otherwise.
struct GridShape {
  int rows = 0, sectors = 0;
  double height = 0;        ///< Metres over all rows.
  double floor_height = 0;  ///< Metres: top of the floor.
  double lump_outer = 0;    ///< Metres: radii shown until rows come; 0 shows nothing until then.
  double lump_inner = 0;
  double lip_radius = kLipRadius;  ///< Metres: of the rim's rounded edges.
  friend bool operator==(const GridShape&, const GridShape&) = default;
};

/// Where a row stands, and the clay it is a row of. Metres.
struct RowPlace {
  double middle = 0;          ///< Height of the row's middle.
  double rim = 0, floor = 0;  ///< Height of the clay, and of the floor's top.
};

/// One changed row of the clay: `sectors` outer radii, then `sectors` inner radii, metres.
struct RowUpdate {
  int row = 0;
  std::vector<float> radii;
  std::optional<RowPlace> place = {};  ///< None: where it was.
  bool torn = false;                   ///< The ring is seen broken open.
};

/// The rows of a Profile turned about its axis, for pictures of vessels. Allocates.
std::vector<RowUpdate> rows_of(const Profile& profile, const GridShape& shape);

}  // namespace onggi::view
