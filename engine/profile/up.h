#pragma once

#include <optional>
#include <string>

#include "engine/profile/ends.h"
#include "engine/profile/extraction.h"
#include "engine/profile/opening.h"

namespace onggi::extraction {

/// What one end of a vessel says about being its mouth.
struct EndSigns {
  double depth = 0.0;   ///< Of what is looked into / height, 0..1.
  double holds = 0.0;   ///< Its volume / the cylinder round the whole vessel, 0..1.
  double radius = 0.0;  ///< Of the end / the largest radius, 0..1.
};

/// What speaks for one of the two ways up; every number for the way its frame has it where > 0.
struct UpSigns {
  EndSigns above, below;
  double file = 0.0;     ///< How much the file's own axes speak for it, -1..1.
  double handles = 0.0;  ///< How high what stands off sits, -1..1.
  double mass = 0.0;     ///< How low the surface's middle lies, -1..1.
};

struct UpChoice {
  bool turn = false;              ///< The other way than the frame has it.
  double sure = 1.0;              ///< 0.5..1.
  UpFrom from = UpFrom::opening;  ///< What spoke for it most.
};

/// Adds the signs up as log odds: a deep hollow that holds much decides alone, and a shallow one
/// does not, since feet are hollow too. Exactly as sure either way round.
UpChoice weigh(const UpSigns& signs);

/// A vessel with its foot below: the frame, ends and views of the way that was chosen.
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
