#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// Decodes a UASTC LDR 4x4 block to sixteen pixels, row by row, 3 bytes each; none for an invalid
/// block. After the UASTC texture specification: ASTC's endpoints and weights in its own packing.
std::optional<std::array<std::uint8_t, 48>> uastc_block(std::span<const std::uint8_t, 16> block);

/// A whole picture: (width + 3) / 4 x (height + 3) / 4 blocks, row by row.
Decoded decode_uastc(std::span<const std::uint8_t> blocks, int width, int height);

}  // namespace onggi::textures
