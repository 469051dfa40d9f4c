#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/clay/clay_mesh.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::render {

/// Reads the clay's surface at each of `pot`'s positions with the shader that draws it: clay.glsl
/// in a mode that writes colour and roughness, without light. So the keepsake's pot matches the
/// kiln screen, and the glaze exists only once. `use` makes the program that reads a part (as in
/// clay.glsl) the current one, with all that it needs.
std::vector<view::SkinPoint> read_surface(const ClayMesh& pot,
                                          const std::function<void(std::size_t part)>& use);

}  // namespace onggi::render
