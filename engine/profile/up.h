#pragma once

#include <optional>
#include <string>

#include "engine/profile/ends.h"
#include "engine/profile/extraction.h"
#include "engine/profile/opening.h"

namespace onggi::extraction {

/// The evidence that one end of a vessel is its mouth.
struct EndSigns {
  double depth = 0.0;   ///< Depth of the visible hollow / height, 0..1.
  double holds = 0.0;   ///< Its volume / the cylinder round the whole vessel, 0..1.
  double radius = 0.0;  ///< Of the end / the largest radius, 0..1.
};

/// The evidence for each of the two directions; a number > 0 supports the frame's direction.
struct UpSigns {
  EndSigns above, below;
  double file = 0.0;     ///< Support from the file's own axes, -1..1.
  double handles = 0.0;  ///< Height of handles and spouts, -1..1.
  double mass = 0.0;     ///< How low the surface's middle is, -1..1.
};

struct UpChoice {
  bool turn = false;              ///< The direction is opposite to the frame's.
  double sure = 1.0;              ///< 0.5..1.
  UpFrom from = UpFrom::opening;  ///< The strongest evidence.
};

/// Adds the evidence as log odds: a deep hollow that holds much decides alone, and a shallow one
/// does not, because feet are hollow too. Symmetric: both directions are judged alike.
UpChoice weigh(const UpSigns& signs);

/// A vessel with its foot below: frame, ends and views of the chosen direction.
struct Standing {
  AxisFrame frame;
  BodyEnds body;
  EndView mouth, base;
  UpChoice choice;
};

/// Weighs which end of `body` is up, or obeys `given` where it lies within 60 degrees of the axis.
/// Looks into both ends and cuts two dozen
/// slices: O(triangles). Allocates.
Standing stand_upright(const TriangleMesh& mesh, const AxisFrame& frame, const BodyEnds& body,
                       const std::optional<Vec3>& given, RayCrossings& rays);

/// The file's axis nearest to `direction`, as vessel.toml writes it: "y", "-z".
std::string axis_name(Vec3 direction);

}  // namespace onggi::extraction
