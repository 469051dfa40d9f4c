#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "kiosk/picture/render/clay_surface.h"
#include "kiosk/picture/render/coat_texture.h"
#include "kiosk/picture/render/ribbons.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// The picture of the unrolled lip, drawn as finely as the frame although the picture in space is
/// smaller: round it in x, from its outer edge to its inner one in y.
struct LipStrip {
  static constexpr int kWide = 256, kTall = 16;
  static float x(float share) { return (0.5f + share * (kWide - 1)) / kWide; }
  static float y(float share) { return (0.5f + share * (kTall - 1)) / kTall; }
  /// Its size in that picture, -1..1, and a little more, so that the outermost middles are drawn.
  static constexpr glm::vec2 kUnrolled{2.004f * (kWide - 1) / kWide, 2.004f * (kTall - 1) / kTall};
};

/// Triangles of `corners`. A crease is no outline: on both sides of it lies the same surface.
struct Ribbons {
  std::vector<EdgeCorner> corners;
  std::vector<std::uint32_t> outlines, creases;
  /// The depth of the wheel head's plane by pixel (x, y, constant), and by how much clay is nearer.
  glm::vec4 head{0, 0, 2, 0};
  /// Its ellipse: 0 for a pixel (x, y, 1) on it, positive outside.
  glm::mat3 disc{0};
};

/// The mesh of the outer wall as the picture draws it, from the foot to the lip.
struct WallMesh {
  int columns = 0, rows = 0;
  int section_rows = 0;      ///< Of the wall's section, from the floor to the lip.
  float from = 0, span = 0;  ///< Angles in the studio, rad.
};

/// The edges of clay and wheel head as ribbons. `texel`: pixels of the frame in one of the picture.
/// Hidden edges are among them: the picture's depth hides them. `coat`: what stands out of it moves
/// the wall's outline.
Ribbons outline_of(const ClaySurface& clay, const CoatTexture& coat, const WallMesh& wall,
                   const view::PotView& pot, const glm::mat4& clip, float texel);

}  // namespace onggi::render
