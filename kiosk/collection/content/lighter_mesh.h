#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::content {

/// A picture that turns is drawn thirty times a second, without a GPU too: so many triangles are no
/// more than its grain, and cost a fifth of a frame.
inline constexpr std::size_t kTurningTriangles = 24000;

/// Fewer triangles over the positions of a mesh.
struct LighterMesh {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Empty: its own are few.
  /// They span seams: colours at the corners are still good, places in pictures are not.
  bool coarse = false;
};

/// What looks like `mesh`, of at most `most` triangles. Where seams or loose corners keep it from
/// being thinned well, it is thinned coarsely. Allocates; any thread; some 0.5 s a million
/// triangles.
LighterMesh lighter(const TriangleMesh& mesh, std::size_t most = kTurningTriangles);

}  // namespace onggi::content
