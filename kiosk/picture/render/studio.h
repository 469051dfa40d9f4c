#pragma once

#include <array>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// Direction to the middle of the studio's one window, unit.
glm::vec3 window_direction(bool right);

/// The studio's light without its window, from a direction (unit, y up). Linear; 1 is white paper
/// in full light. A plaster room lit from the left: bright ceiling, a dim warm far wall, a low
/// floor. Lit from the right, it is mirrored.
glm::vec3 studio_light(glm::vec3 direction);

/// Nine terms of the irradiance (over pi) from `light` on a surface, in light.glsl's order.
/// Integrated over an octahedral grid of size x size directions.
std::array<glm::vec3, 9> irradiance_terms(glm::vec3 (*light)(glm::vec3), int size);

/// The studio for the shaders, lit from either side. Computed once on the CPU in about ten
/// milliseconds.
class Studio {
 public:
  Studio();
  /// Sets the light's side; it starts on the left.
  void put_window(bool right) { right_ = right; }
  bool window_right() const { return right_; }
  /// Sets the uniforms of light.glsl; binds the sky to texture unit `unit`.
  void light(const Program& program, int unit) const;
  const Texture& grain() const { return grain_; }

 private:
  struct Lit {
    std::array<glm::vec3, 9> terms;
    Texture sky;
  };
  std::array<Lit, 2> lit_;  // from the left, from the right
  bool right_ = false;
  Texture grain_;
};

}  // namespace onggi::render
