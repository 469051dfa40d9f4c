#pragma once

#include <vector>

#include "kiosk/picture/render/outline.h"

namespace onggi::render {

/// A point of an edge.
struct EdgePoint {
  glm::vec2 at{0.0f};  ///< Pixels of the frame, from the lower left.
  float metres = 0;    ///< From the eye, along its view.
  glm::vec3 strip{-1};
  bool narrow = false;                    ///< All of it is in the strip, as of a lip.
  float most_in = 1e9f, most_out = 1e9f;  ///< Pixels to both sides, at most.
};

/// To the right of `way`, of length 1 (0 if there is none).
glm::vec2 right_of(glm::vec2 way);

/// Appends a triangle strip of the corners from `begun` on.
void join(std::vector<std::uint32_t>& indices, std::size_t begun, std::size_t end);

/// Adds a ribbon along `line`, `wide` pixels to both sides. What is in front lies left of the way.
/// Steep parts are widened along x and flat ones along y, so that a ribbon never folds, however
/// narrow its bends; where it is neither, both are drawn, with the same colours.
void add_ribbon(Ribbons& to, const std::vector<EdgePoint>& line, bool closed, float wide);

}  // namespace onggi::render
