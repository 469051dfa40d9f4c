#pragma once

#include <cstdint>
#include <span>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// A KTX 2.0 file as glTF's KHR_texture_basisu wants it: one flat picture of BasisLZ/ETC1S, or of
/// UASTC with or without Zstandard. Of its levels the smallest that is not under `wanted_side` is
/// decoded, and refused where that has more than `most_side`. Turned as the file has it, as glTF
/// means it: the first row is v = 0.
Decoded decode_ktx2(std::span<const std::uint8_t> bytes, unsigned most_side, unsigned wanted_side);

}  // namespace onggi::textures
