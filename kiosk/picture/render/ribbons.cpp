#include "kiosk/picture/render/ribbons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::render {
namespace {

constexpr float kStraight = 0.1f;       // pixels that a piece may lie beside its line
constexpr float kLongestPiece = 48.0f;  // pixels of a piece
constexpr float kOblique = 0.6f;        // least part of a normal along the axis of a ribbon's width
constexpr float kSoft = 0.75f;          // pixels to both sides that cover part of a pixel

/// To the right of `way`, of length 1 (0 if there is none).
glm::vec2 right_of(glm::vec2 way) {
  const float length = glm::length(way);
  return length > 1e-6f ? glm::vec2(way.y, -way.x) / length : glm::vec2(0.0f);
}

/// The last point up to which a piece from `first` is straight.
std::size_t end_of_piece(const std::vector<EdgePoint>& line, std::size_t first) {
  std::size_t end = first + 1;
  while (end + 1 < line.size()) {
    const glm::vec2 way = line[end + 1].at - line[first].at;
    if (glm::length(way) > kLongestPiece) break;
    const glm::vec2 across = right_of(way);
    const bool straight =
        std::all_of(line.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                    line.begin() + static_cast<std::ptrdiff_t>(end) + 1, [&](const EdgePoint& p) {
                      return std::abs(glm::dot(p.at - line[first].at, across)) <= kStraight &&
                             glm::dot(p.at - line[first].at, way) >= 0.0f;
                    });
    if (!straight) break;
    ++end;
  }
  return end;
}

/// A piece widened along x and one widened along y leave a square beside the bend between them. It
/// lies wholly on one side of the edge.
void add_bend(std::vector<EdgeCorner>& corners, std::vector<std::uint32_t>& indices,
              const EdgePoint& at, glm::vec2 before, glm::vec2 after, float texel) {
  if ((std::abs(before.x) > std::abs(before.y)) == (std::abs(after.x) > std::abs(after.y))) return;
  const bool outside = before.x * after.y - before.y * after.x > 0.0f;
  const float side = outside ? 1.0f : -1.0f, most = outside ? at.most_out : at.most_in;
  const glm::vec2 way = std::min(texel, most) * side * glm::sign(before + after);
  const glm::vec2 out = glm::normalize(before + after);
  const auto base = static_cast<std::uint32_t>(corners.size());
  for (const glm::vec2 share : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)})
    corners.push_back({at.at + share * way, glm::dot(share * way, out), at.depths, at.strip});
  for (const std::uint32_t k : {0u, 1u, 2u, 2u, 1u, 3u}) indices.push_back(base + k);
}

}  // namespace

void put_farthest_first(const std::vector<EdgeCorner>& corners,
                        std::vector<std::uint32_t>& indices) {
  constexpr std::size_t kQuad = 6;
  std::vector<std::array<std::uint32_t, kQuad>> quads(indices.size() / kQuad);
  for (std::size_t i = 0; i < quads.size(); ++i)
    std::copy_n(&indices[kQuad * i], kQuad, quads[i].begin());
  std::stable_sort(quads.begin(), quads.end(), [&](const auto& a, const auto& b) {
    return corners[a[0]].depths.x > corners[b[0]].depths.x;
  });
  for (std::size_t i = 0; i < quads.size(); ++i)
    std::copy_n(quads[i].begin(), kQuad, &indices[kQuad * i]);
}

void add_ribbon(std::vector<EdgeCorner>& corners, std::vector<std::uint32_t>& indices,
                const std::vector<EdgePoint>& line, float texel) {
  glm::vec2 last(0.0f);
  for (std::size_t i = 0; i + 1 < line.size();) {
    const std::size_t end = end_of_piece(line, i);
    const glm::vec2 normal = right_of(line[end].at - line[i].at);
    if (i > 0) add_bend(corners, indices, line[i], last, normal, texel);
    last = normal;
    const float wide = texel * (std::abs(normal.x) + std::abs(normal.y));
    for (const int axis : {0, 1}) {
      if (std::abs(normal[axis]) < kOblique) continue;
      glm::vec2 out(0.0f);
      out[axis] = 1.0f / normal[axis];
      const auto base = static_cast<std::uint32_t>(corners.size());
      for (const EdgePoint* p : {&line[i], &line[end]})
        for (const float beyond : {std::max(std::min(wide, p->most_out), kSoft),
                                   -std::max(std::min(wide, p->most_in), kSoft)})
          corners.push_back({p->at + beyond * out, beyond, p->depths, p->strip});
      for (const std::uint32_t k : {0u, 1u, 2u, 2u, 1u, 3u}) indices.push_back(base + k);
    }
    i = end;
  }
}

}  // namespace onggi::render
