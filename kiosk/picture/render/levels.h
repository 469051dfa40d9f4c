#pragma once

#include <array>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

inline constexpr int kLevels = 64;

/// A vessel's mean radii at kLevels equally spaced heights, and how much light its own shape
/// blocks, in closed forms for a surface of revolution. Plain numbers; the texture is made from
/// them.
struct Levels {
  double height = 0;
  std::array<float, kLevels> outer{}, inner{};  ///< Metres; inner 0 if solid.

  /// Row 0 (outer wall): radius; angle from the vertical, radians, below which a shoulder above
  /// blocks the light; visible share of the sky. Row 1 (inner wall): radius; radius and height of
  /// the ring above that narrows the view most. Four floats each.
  std::array<float, 2 * kLevels * 4> light() const;
};

/// The largest difference between the two in height or a radius, metres.
double apart(const Levels& a, const Levels& b);

/// Makes or renews the kLevels x 2 texture that light.glsl reads.
void upload(const Levels& levels, Texture& texture);

}  // namespace onggi::render
