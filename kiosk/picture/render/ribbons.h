#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace onggi::render {

/// A corner of a ribbon (edge.glsl). Plain numbers.
struct EdgeCorner {
  glm::vec2 at{0.0f};   ///< Pixels of the frame, from the lower left,
  float beyond = 0;     ///< and how far beyond the edge, negative inside.
  glm::vec3 depths{0};  ///< As EdgePoint has them.
  glm::vec3 strip{-1};  ///< Too.
  friend bool operator==(const EdgeCorner&, const EdgeCorner&) = default;
};

/// A point of an edge.
struct EdgePoint {
  glm::vec2 at{0.0f};  ///< Pixels of the frame, from the lower left.
  /// Of an outline: nearer hides it, farther lies behind it; 1: the wheel head's, 0: the clay's on
  /// it, -1: of what stands elsewhere. Of a crease:
  /// pixels beyond it and inside where no texel reaches over it; nearer hides it.
  glm::vec3 depths{0};
  glm::vec3 strip{-1};  ///< Colours: place at the edge, and its change in y a pixel. None: x < 0.
  float most_in = 1e9f, most_out = 1e9f;  ///< Pixels to both sides, at most.
};

/// Sorts ribbons by depth: where an edge ends at a nearer one, the nearer one's ribbon is the true
/// one, and is drawn last.
void put_farthest_first(const std::vector<EdgeCorner>& corners,
                        std::vector<std::uint32_t>& indices);

/// Adds a ribbon along `line`, which hides a texel of `texel` pixels wherever the edge runs through
/// it. What is in front lies left of the way. Steep pieces are widened along x and flat ones along
/// y, so that neighbours meet in a line; pieces that are neither are drawn in both ways.
void add_ribbon(std::vector<EdgeCorner>& corners, std::vector<std::uint32_t>& indices,
                const std::vector<EdgePoint>& line, float texel);

}  // namespace onggi::render
