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

/// The strongest evidence for the upright direction.
enum class UpFrom {
  opening,  ///< One end is open and holds more.
  file,     ///< The file's own direction.
  foot,     ///< It stands on the wider closed end.
  handles,  ///< They sit above the middle.
  mass,     ///< Most of it lies below the middle.
  given,    ///< ExtractionOptions::up.
};

/// A profile from triangles, with its reliability.
struct ExtractedProfile {
  /// Below this certainty of the direction there is a warning.
  static constexpr double kSureUp = 0.95;
  Profile profile;               ///< Mesh units are taken as metres.
  Vec3 axis_origin;              ///< A point on the axis (at the foot), mesh units.
  Vec3 axis_direction{0, 1, 0};  ///< Unit, foot to rim, mesh axes.
  UpFrom up_from = UpFrom::opening;
  double up_sure = 1.0;  ///< 0.5..1; below kSureUp a warning names the line to write.
  /// For each point of `profile`: both sides of one wall were seen there.
  std::vector<bool> inner_seen;
  double inferred_wall = 0.0;    ///< Thickness put where no wall was seen, metres; 0: nowhere.
  double symmetry = 0.0;         ///< 0..1: 1 - spread of outer radius round the axis / mean radius.
  double masked_fraction = 0.0;  ///< Share of (height, angle) cells left out as handle, spout, lid.
  std::vector<std::string> warnings;
};

/// Finds axis, direction, outer and inner radius over height. Problem if the mesh is not a body of
/// revolution, has no size or has non-finite positions. `name` goes into the Problem. Allocates.
Result<ExtractedProfile> extract_profile(const TriangleMesh& mesh, const ExtractionOptions& options,
                                         const std::string& name);

}  // namespace onggi
