#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "kiosk/picture/render/clay_surface.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// A corner of a ribbon (edge.glsl). Plain numbers.
struct EdgeCorner {
  glm::vec2 at{0.0f};   ///< Pixels of the frame, from the lower left,
  float beyond = 0;     ///< and how far beyond the edge, negative inside.
  float metres = 0;     ///< From the eye, along its view.
  glm::vec3 strip{-1};  ///< Colours: place at the edge, and its change in y a pixel. None: x < 0.
  /// Away from the thing in front, on the screen: 127 times the unit vector. Then 127 if the strip
  /// has all of the thing.
  std::array<std::int8_t, 4> normal{};
  friend bool operator==(const EdgeCorner&, const EdgeCorner&) = default;
};

/// A corner of the surface that is drawn once more into the strips (clay.glsl, wheel.glsl).
struct StripCorner {
  glm::vec3 place{0.0f};
  glm::vec2 strip{0.0f};  ///< -1..1 over the strips' picture.
  friend bool operator==(const StripCorner&, const StripCorner&) = default;
};

/// The picture of strips: what lies within a few pixels of an edge, drawn as finely as the frame
/// although the picture in space is smaller. Round or along an edge in x, away from it in y.
struct Strips {
  static constexpr int kWide = 256, kTall = 24;
  static constexpr int kLip = 0, kLipRows = 8;                ///< From the outer edge to the inner.
  static constexpr int kLeft = 8, kRight = 13;                ///< Of the wall.
  static constexpr int kWheel = 18, kRows = 5;                ///< Also of both of these.
  static float x(float share);                                ///< As a texture's coordinate.
  static float y(float row) { return (row + 0.5f) / kTall; }  ///< Of the middle of a row.
};

struct Ribbons {
  std::vector<EdgeCorner> corners;
  std::vector<std::uint32_t> indices;  ///< One triangle strip.
  std::vector<StripCorner> strips;
  std::vector<std::uint32_t> wall, wheel;  ///< Triangle strips of `strips`.
};

/// The edges of clay and wheel head as ribbons, from the clay's own rows. `wide`: how far a ribbon
/// reaches to both sides, pixels. Hidden edges are among them: the picture's depth hides them.
Ribbons outline_of(const ClaySurface& clay, const view::PotView& pot, const glm::mat4& clip,
                   float wide);

}  // namespace onggi::render
