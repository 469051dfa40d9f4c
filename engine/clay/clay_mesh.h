#pragma once

#include <cstdint>
#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/profile/mesh.h"

namespace onggi {

/// The clay as a closed mesh in its own turning frame: foot, outer wall, rim, inner wall and floor,
/// with the real throwing lines. The walls take every n-th row and sector, n the least that keeps
/// them at `most_rows` x `most_sectors`, or where no such n is a divisor of the sectors, unequal
/// steps; edges between the five faces are sharp (their vertices are doubled, at equal positions).
/// Metres, y up, foot at 0. Allocates; O(vertices).
TriangleMesh mesh_of(const ClayView& clay, int most_rows = 400, int most_sectors = 180);

/// The faces of that mesh, in the order of its positions.
enum class ClayFace : std::uint8_t { foot, outer, rim, inner, floor };

/// mesh_of(), with the face of each position.
struct ClayMesh {
  TriangleMesh mesh;
  std::vector<ClayFace> faces;  ///< One a position.
};
ClayMesh faced_mesh_of(const ClayView& clay, int most_rows = 400, int most_sectors = 180);

}  // namespace onggi
