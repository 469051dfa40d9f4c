#pragma once

#include <array>

#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/view/studio_window.h"

namespace onggi::render {

/// Direction to the middle of the studio's one window (view::PotView::window), unit.
glm::vec3 window_direction(double window);

/// The studio's light without its window, from a direction (unit, y up). Linear; 1 is white paper
/// in full light. A plaster room lit from the left: bright ceiling, a dim warm far wall, a low
/// floor. Lit from elsewhere, the room is turned.
glm::vec3 studio_light(glm::vec3 direction);

/// Nine terms of the irradiance (over pi) from `light` on a surface, in light.glsl's order.
/// Integrated over an octahedral grid of size x size directions.
std::array<glm::vec3, 9> irradiance_terms(glm::vec3 (*light)(glm::vec3), int size);

/// The studio for the shaders, whose window goes round the pot. Computed once on the CPU in some
/// milliseconds.
class Studio {
 public:
  Studio();
  /// Sets where the light is, rad; it starts on the left.
  void put_window(double window) { window_ = window; }
  double window() const { return window_; }
  /// Sets the uniforms of light.glsl; binds the sky to texture unit `unit`.
  void light(const Program& program, int unit) const;
  const Texture& grain() const { return grain_; }

 private:
  std::array<glm::vec3, 9> terms_;  // lit from the left, like the sky
  Texture sky_, grain_;
  double window_ = view::kWindowLeft;
};

}  // namespace onggi::render
