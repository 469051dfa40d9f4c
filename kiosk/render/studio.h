#pragma once

#include <array>

#include "kiosk/render/gl.h"

namespace onggi::render {

/// Towards the middle of the studio's one window.
glm::vec3 window_direction();

/// The studio's light without its window, in a direction (unit, y up). Linear; 1 is white paper in
/// full light. A plaster room lit from the left: bright ceiling, a dim warm far wall, a low floor.
glm::vec3 studio_light(glm::vec3 direction);

/// Nine terms of the irradiance (over pi) that `light` throws on a surface, in light.glsl's order.
/// Integrated over an octahedral grid of size x size directions.
std::array<glm::vec3, 9> irradiance_terms(glm::vec3 (*light)(glm::vec3), int size);

/// The studio as the shaders read it. Made once, by the CPU, in a few milliseconds.
class Studio {
 public:
  Studio();
  /// Sets the uniforms of light.glsl; binds the sky to texture unit `unit`.
  void light(const Program& program, int unit) const;
  const Texture& grain() const { return grain_; }

 private:
  std::array<glm::vec3, 9> terms_;
  Texture sky_;
  Texture grain_;
};

}  // namespace onggi::render
