#pragma once

#include <cstdint>
#include <vector>

namespace onggi::view {

/// Pixels by value: sRGB, straight alpha, 4 bytes a pixel, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace onggi::view
