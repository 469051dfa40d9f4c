#pragma once

#include <cstdint>
#include <span>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// Decodes a KTX 2.0 file for glTF's KHR_texture_basisu: one flat picture of BasisLZ/ETC1S, or of
/// UASTC with or without Zstandard. Decodes the smallest level that is not under `wanted_side`, and
/// refuses one with more than `most_side`. The first row is v = 0, as in the file and in glTF.
Decoded decode_ktx2(std::span<const std::uint8_t> bytes, unsigned most_side, unsigned wanted_side);

}  // namespace onggi::textures
