#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/math/vec.h"
#include "engine/profile/profile.h"

namespace onggi {

/// Triangles in space, metres, y up, counter-clockwise seen from outside the material.
struct TriangleMesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;  ///< Empty, or one unit vector a position.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A closed drawn section in (radius, height): from the axis under the foot, along the outer wall
/// to the rim, and down the inner wall to the axis on the floor. Metres. May overhang.
struct Section {
  std::vector<Vec2> outline;  ///< x = radius >= 0, y = height >= 0.
};

/// Turns `section` about the y axis in `sectors` (>= 3) steps; watertight, smooth normals except at
/// corners sharper than 40 degrees. Allocates.
TriangleMesh revolve(const Section& section, int sectors);

/// The section of a Profile with a flat foot, a flat rim and a flat floor at floor_height().
Section section_of(const Profile& p);

}  // namespace onggi
