#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/coil_view.h"

namespace onggi::render {

/// The coil on the rim as triangles, counterclockwise from outside. Plain numbers; metres.
struct CoilMesh {
  struct Corner {
    glm::vec3 at{0.0f}, normal{0.0f};
  };
  std::vector<Corner> corners;
  std::vector<std::uint32_t> indices;
};

/// Part of the circle that is left out, rad.
struct Opening {
  float from = 0.0f, angle = 0.0f;
};

/// `coil` as round tubes with round ends, turned by `turned` (rad) about the axis, without
/// `opening`; there the ends are flat. Allocates no more than it has before.
void make_coil(CoilMesh& mesh, const CoilOnRim& coil, double turned, Opening opening);

}  // namespace onggi::render
