#include <cstdint>
#include <cstdlib>
#include <span>

#include "kiosk/collection/textures/texture_decoder.h"

// Any bytes are a picture that a scan names. What onggi-texture decodes in a process of its own is
// decoded here in this one.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const onggi::textures::TextureLimits limits{512, 64};
  const auto decoded = onggi::textures::decode_texture(std::span(data, size), limits);
  if (!decoded) {
    if (decoded.error().empty()) std::abort();
    return 0;
  }
  const auto width = static_cast<std::size_t>(decoded->width),
             height = static_cast<std::size_t>(decoded->height);
  if (width == 0 || height == 0 || width > limits.wanted_side || height > limits.wanted_side ||
      decoded->rgb.size() != 3 * width * height)
    std::abort();
  return 0;
}
