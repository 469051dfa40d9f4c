#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::content {

/// A turning picture is drawn thirty times a second, also without a GPU. This many triangles are as
/// fine as its pixels and take a fifth of a frame.
inline constexpr std::size_t kTurningTriangles = 24000;

/// A mesh with fewer triangles over the same positions.
struct LighterMesh {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Empty if the mesh already has few.
  /// True if triangles cross seams: colours at the corners are still right, picture coordinates are
  /// not.
  bool coarse = false;
};

/// Reduces `mesh` to at most `most` triangles with the same look. If seams or loose corners prevent
/// good thinning, it is thinned coarsely. Allocates; any thread; about 0.5 s a million triangles.
LighterMesh lighter(const TriangleMesh& mesh, std::size_t most = kTurningTriangles);

}  // namespace onggi::content
