#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"
#include "engine/profile/profile.h"

namespace onggi {

struct ExtractionOptions {
  int slices = 200;        ///< Heights in the profile, 16..2000.
  std::optional<Vec3> up;  ///< Up in the mesh's own axes; absent = decided from the shape.
};

/// What told which end is up.
enum class UpFrom {
  opening,  ///< One end can be looked into deeper.
  file,     ///< Neither is open, or both are: as the file stands.
  given,    ///< ExtractionOptions::up.
};

/// A profile read from triangles, and how far it can be trusted.
struct ExtractedProfile {
  Profile profile;               ///< Mesh units are taken as metres.
  Vec3 axis_origin;              ///< A point on the axis (at the foot), mesh units.
  Vec3 axis_direction{0, 1, 0};  ///< Unit, foot to rim, mesh axes.
  UpFrom up_from = UpFrom::opening;
  std::vector<bool> inner_seen;  ///< By point of `profile`: its inner radius was measured.
  double inferred_wall = 0.0;    ///< Thickness put where no wall was seen, metres; 0: nowhere.
  double symmetry = 0.0;         ///< 0..1: 1 - spread of outer radius round the axis / mean radius.
  double masked_fraction = 0.0;  ///< Share of (height, angle) cells left out as handle, spout, lid.
  std::vector<std::string> warnings;
};

/// Finds axis, up, outer and inner radius over height. Problem when the mesh is no body of
/// revolution, has no extent or non-finite positions. `name` goes into the Problem. Allocates.
Result<ExtractedProfile> extract_profile(const TriangleMesh& mesh, const ExtractionOptions& options,
                                         const std::string& name);

}  // namespace onggi
