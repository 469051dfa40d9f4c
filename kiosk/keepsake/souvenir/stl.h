#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::souvenir {

/// Binary STL in millimetres, z up, outside facing outwards, as slicers expect. Triangles without
/// area are left out. The same mesh gives the same bytes.
std::vector<std::byte> write_stl(const TriangleMesh& mesh, const std::string& title);

}  // namespace onggi::souvenir
