#pragma once

#include <array>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

inline constexpr int kLevels = 64;

/// A vessel's mean radii at kLevels even heights, and what its own shape hides of the light: the
/// closed forms that a surface of revolution allows. Plain numbers; the texture is made from them.
struct Levels {
  double height = 0;
  std::array<float, kLevels> outer{}, inner{};  ///< Metres; inner 0 where solid.

  /// Row 0 (outer wall): radius; angle from the vertical below which light is hidden by a shoulder
  /// above, radians; share of the sky that is seen. Row 1 (inner wall): radius; radius and height
  /// of the ring above that narrows the view most. Four floats each.
  std::array<float, 2 * kLevels * 4> light() const;
};

/// The farthest that anything of one is from the other, metres: height or a radius.
double apart(const Levels& a, const Levels& b);

/// Makes or renews the kLevels x 2 texture that light.glsl reads.
void upload(const Levels& levels, Texture& texture);

}  // namespace onggi::render
