#pragma once

#include <array>

namespace onggi::view {

/// What a pot's surface is at a place, whatever light falls on it.
struct SkinPoint {
  std::array<float, 3> color{};  ///< Linear, 0..1: the share of light that it gives back.
  float roughness = 1.0f;        ///< 0 like a mirror .. 1 matt; the square is glTF's alpha.
};

}  // namespace onggi::view
