#pragma once

#include <cstddef>
#include <vector>

#include "engine/profile/mesh.h"
#include "engine/scene/coil_view.h"

namespace onggi::render {

/// Part of the circle that is left out, rad.
struct Opening {
  float from = 0.0f, angle = 0.0f;
};

/// Neighbouring places of a coil that are drawn: first..last, modulo their number.
struct CoilRun {
  std::size_t first = 0, last = 0;
  bool flat_first = false, flat_last = false;  ///< Cut there.
  bool ring = false;                           ///< All of them: it has no ends.
};
/// The runs of `coil`, turned by `turned` (rad), outside `opening`.
std::vector<CoilRun> runs_of(const CoilOnRim& coil, double turned, Opening opening);
/// Angle of the middle of `place` about the axis, rad, studio frame.
float angle_of(const CoilOnRim& coil, std::size_t place, double turned);

/// `coil` as round tubes with round ends, turned by `turned` (rad) about the axis, without
/// `opening`; there the ends are flat. Closed, with normals. Empty if nothing lies. Plain numbers,
/// metres; allocates.
TriangleMesh coil_mesh(const CoilOnRim& coil, double turned, Opening opening);

}  // namespace onggi::render
