#include "kiosk/collection/textures/texture_decoder.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "kiosk/collection/textures/codecs.h"
#include "kiosk/collection/textures/ktx2.h"
#include "kiosk/collection/textures/srgb.h"

namespace onggi::textures {
namespace {

/// The light of each of the 256 values, and of the values between.
struct LightTable {
  std::array<float, 256> light{};
  std::array<float, 255> between{};
  LightTable() {
    for (std::size_t i = 0; i < 256; ++i)
      light[i] = static_cast<float>(light_of_srgb(static_cast<double>(i) / 255.0));
    for (std::size_t i = 0; i < 255; ++i)
      between[i] = static_cast<float>(light_of_srgb((static_cast<double>(i) + 0.5) / 255.0));
  }
  std::uint8_t value(float of) const {
    return static_cast<std::uint8_t>(std::upper_bound(between.begin(), between.end(), of) -
                                     between.begin());
  }
};

}  // namespace

TexturePixels shrunk(TexturePixels pixels, unsigned wanted_side) {
  const auto width = static_cast<std::size_t>(pixels.width),
             height = static_cast<std::size_t>(pixels.height);
  const std::size_t wanted = std::max(1u, wanted_side);
  const std::size_t k = (std::max(width, height) + wanted - 1) / wanted;
  if (k <= 1) return pixels;
  static const LightTable kTable;
  TexturePixels out;
  const std::size_t across = (width + k - 1) / k, down = (height + k - 1) / k;
  out.width = static_cast<int>(across);
  out.height = static_cast<int>(down);
  out.rgb.reserve(3 * across * down);
  for (std::size_t y = 0; y < down; ++y)
    for (std::size_t x = 0; x < across; ++x) {
      std::array<float, 3> sum{};
      const std::size_t right = std::min(width, (x + 1) * k), below = std::min(height, (y + 1) * k);
      for (std::size_t v = y * k; v < below; ++v)
        for (std::size_t u = x * k; u < right; ++u)
          for (std::size_t c = 0; c < 3; ++c)
            sum[c] += kTable.light[pixels.rgb[3 * (v * width + u) + c]];
      const auto count = static_cast<float>((right - x * k) * (below - y * k));
      for (const float c : sum) out.rgb.push_back(kTable.value(c / count));
    }
  return out;
}

Decoded decode_texture(std::span<const std::uint8_t> bytes, const TextureLimits& limits) {
  const auto begins = [&bytes](std::size_t at, const char* with, std::size_t size) {
    return bytes.size() >= at + size && std::memcmp(bytes.data() + at, with, size) == 0;
  };
  Decoded out;
  if (begins(0, "\x89PNG\r\n\x1A\n", 8))
    out = decode_png(bytes, limits.most_side);
  else if (begins(0, "\xFF\xD8\xFF", 3))
    out = decode_jpeg(bytes, limits.most_side);
  else if (begins(0, "RIFF", 4) && begins(8, "WEBP", 4))
    out = decode_webp(bytes, limits.most_side);
  else if (begins(0, "\xABKTX 20\xBB\r\n\x1A\n", 12))
    out = decode_ktx2(bytes, limits.most_side, limits.wanted_side);
  else
    out = tl::unexpected(
        std::string(bytes.empty() ? "it is empty" : "it is not a PNG, JPEG, WebP or KTX2"));
  if (!out) return out;
  return shrunk(std::move(*out), limits.wanted_side);
}

}  // namespace onggi::textures
