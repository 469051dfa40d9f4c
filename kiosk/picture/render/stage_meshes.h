#pragma once

#include <cstdint>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// Coordinates across and up a section (clay.glsl, PART 4): the floor at heights -1..0, the wall at
/// 0..1 in `rows` steps. Only the round lip has corners between its faces.
Mesh section_mesh(int rows);

/// A disc whose edge has `corners` (as in disc_indices), each (0..1 round, 1, 0), and the band
/// under it, whose places end in 1 (wheel.glsl).
Mesh wheel_head_mesh(std::uint32_t corners);

}  // namespace onggi::render
