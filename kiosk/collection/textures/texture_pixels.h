#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::textures {

/// A picture for a surface, by value: sRGB, 3 bytes a pixel, rows from the top.
struct TexturePixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
  friend bool operator==(const TexturePixels&, const TexturePixels&) = default;
};

/// Pixels, or the reason why there are none: a clause without a full stop, "it ends too early".
using Decoded = tl::expected<TexturePixels, std::string>;

}  // namespace onggi::textures
