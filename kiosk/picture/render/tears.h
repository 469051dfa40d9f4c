#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// The torn rings of the clay, and a texture with each height's distance from them. Without a tear
/// there is no texture.
class Tears {
 public:
  static constexpr int kHeights = 1024;
  static constexpr float kFurthest = 0.02f;  ///< Largest distance in the texture, metres.

  /// Starts with a grid without tears: `rows` drawn rows, each for `row_step` of the engine's.
  void reset(int rows, int row_step);
  /// `row` in the engine's grid.
  void note(int row, bool torn);
  bool any() const { return torn_rows_ > 0; }
  /// Renews the texture if rows tore or healed, or if they `moved`. `middles`: heights of the drawn
  /// rows, rising to `height`, metres.
  void refresh(std::span<const float> middles, float height, bool moved);
  /// A table over kHeights equal steps of the height, foot and rim included. Metres to the edge of
  /// the nearest torn ring: negative in whole clay, positive inside a tear.
  const Texture& texture() const { return texture_; }

 private:
  void measure(std::span<const float> middles, float height);

  std::vector<std::uint8_t> torn_;  // for the engine's rows
  std::vector<std::uint8_t> marked_;
  std::vector<float> distance_;
  int torn_rows_ = 0, row_step_ = 1;
  bool changed_ = false;
  Texture texture_;
};

}  // namespace onggi::render
