#pragma once

#include <array>

namespace onggi::view {

/// A pot's surface at a place, independent of light.
struct SkinPoint {
  std::array<float, 3> color{};  ///< Linear, 0..1: the reflected share of light.
  float roughness = 1.0f;        ///< 0 like a mirror .. 1 matt; the square is glTF's alpha.
};

}  // namespace onggi::view
