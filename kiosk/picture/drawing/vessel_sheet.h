#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/math/vec.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/content/vessel.h"

namespace onggi::drawing {

/// A vessel as an archaeological drawing, as plain values: the section to the left of the axis, the
/// view to its right, and its annotations. Lengths in metres; x = distance from the axis to the
/// right, y = height above the foot.
struct VesselSheet {
  std::string title, subtitle;
  std::vector<std::string> facts;  ///< Figures, one line each.
  std::vector<std::string> notes;  ///< Warnings that a reader should know before trusting it.
  std::string credit;              ///< Credit and licence, one line.

  std::vector<Vec2> outer;  ///< The profile's outer line, foot to rim, x > 0.
  std::vector<Vec2> wall;   ///< The wall's section, closed, x > 0, seen or inferred.
  /// Parts of the inner line that were seen, and parts that were inferred, foot to rim, x > 0.
  std::vector<std::vector<Vec2>> inner_seen, inner_inferred;
  std::vector<double> edges;        ///< Heights where the outer line turns sharply.
  std::vector<double> inner_edges;  ///< The same on the inside, with the floor.

  TriangleMesh mesh;  ///< Turned so that parts that were left out are to the right. y up.
  std::vector<std::array<Vec2, 2>>
      slice;                ///< The mesh cut by the drawing's plane, left half, x < 0.
  std::vector<Vec2> limit;  ///< The surface beyond this line (foot to rim) was left out, x > 0.
  double masked_fraction = 0.0;

  double height = 0.0, belly = 0.0, belly_height = 0.0, mouth = 0.0, foot = 0.0;
  /// Where mouth and foot were measured: their widest places, near the ends of the vessel.
  double mouth_height = 0.0, foot_height = 0.0;
  bool true_size = true;  ///< The size is the vessel's and not a guess.
  double up_sure = 1.0;   ///< Confidence that the foot is below, 0.5..1.
  bool up_doubted = false;
};

/// The sheet of `vessel`, in English, for curators. Allocates.
VesselSheet sheet_of(const content::Vessel& vessel);

}  // namespace onggi::drawing
