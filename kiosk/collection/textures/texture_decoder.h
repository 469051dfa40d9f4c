#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// Limits for a picture, and the wanted size.
struct TextureLimits {
  unsigned most_side = 8192;    ///< Pixels; a larger one is refused by its header.
  unsigned wanted_side = 1024;  ///< Pixels; a larger one is shrunk to it.
};

/// Decodes a PNG, JPEG, WebP or KTX2, recognised by its first bytes. As glTF 2.0, section 3.8.2,
/// requires, colour profiles, gamma and rotations in the picture are ignored. Transparency is
/// ignored; animated pictures and CMYK are refused. Memory: about ten bytes a pixel of the file.
/// Damage is an error and never shown as a picture. Meant for a process of its own; allocates.
Decoded decode_texture(std::span<const std::uint8_t> bytes, const TextureLimits& limits);

/// Averages every `k` x `k` pixels as light into one, with the smallest `k` for which no side is
/// longer than `wanted_side`.
TexturePixels shrunk(TexturePixels pixels, unsigned wanted_side);

}  // namespace onggi::textures
