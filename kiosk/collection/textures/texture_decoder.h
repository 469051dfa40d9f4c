#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/base/result.h"
#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// What is allowed of a picture, and how much of it is wanted.
struct TextureLimits {
  unsigned most_side = 8192;    ///< Pixels; a larger one is refused by its header.
  unsigned wanted_side = 1024;  ///< Pixels; a larger one is shrunk to it.
};

/// Decodes a PNG, JPEG, WebP or KTX2 by its first bytes, whatever it is called. As glTF 2.0,
/// section 3.8.2, asks: colour profiles, gamma and turns written in the picture are not used.
/// Transparency is left out, animated pictures and CMYK are refused. Memory: about ten bytes a
/// pixel of the file. Damage is told, never shown as a picture. Meant for a process of its own;
/// allocates.
Decoded decode_texture(std::span<const std::uint8_t> bytes, const TextureLimits& limits);

/// Every `k` x `k` pixels become one, their mean as light: the smallest `k` with which no side is
/// longer than `wanted_side`.
TexturePixels shrunk(TexturePixels pixels, unsigned wanted_side);

}  // namespace onggi::textures
