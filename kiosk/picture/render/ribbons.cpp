#include "kiosk/picture/render/ribbons.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr float kPiece = 8.0f;     // pixels between two corners, at most
constexpr float kSmoothed = 1.0f;  // pixels to both sides over which a direction is taken
constexpr float kOblique = 0.6f;   // least part of a normal along the axis of a ribbon's width
constexpr float kSoft = 0.75f;     // pixels to both sides that cover part of a pixel

// With corners so close that each turns only the piece next to it.
std::vector<EdgePoint> divided(const std::vector<EdgePoint>& line, bool closed) {
  std::vector<EdgePoint> points;
  for (std::size_t i = 0; i < line.size(); ++i) {
    points.push_back(line[i]);
    if (i + 1 == line.size() && !closed) break;
    const EdgePoint &from = line[i], &to = line[(i + 1) % line.size()];
    const int parts = std::min(static_cast<int>(glm::length(to.at - from.at) / kPiece), 256);
    for (int k = 1; k <= parts; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(parts + 1);
      points.push_back({glm::mix(from.at, to.at, t), glm::mix(from.metres, to.metres, t),
                        glm::mix(from.strip, to.strip, t), from.narrow,
                        glm::mix(from.most_in, to.most_in, t),
                        glm::mix(from.most_out, to.most_out, t)});
    }
  }
  return points;
}

std::vector<glm::vec2> normals_of(const std::vector<EdgePoint>& points, bool closed) {
  const std::size_t n = points.size();
  const auto neighbour = [&](std::size_t i, bool on) {
    std::size_t k = i;
    for (std::size_t steps = 0; steps < n; ++steps) {
      if (!closed && (on ? k + 1 == n : k == 0)) break;
      k = (k + (on ? 1 : n - 1)) % n;
      if (glm::length(points[k].at - points[i].at) >= kSmoothed) break;
    }
    return points[k].at;
  };
  std::vector<glm::vec2> normals(n);
  for (std::size_t i = 0; i < n; ++i)
    normals[i] = right_of(neighbour(i, true) - neighbour(i, false));
  return normals;
}

}  // namespace

glm::vec2 right_of(glm::vec2 way) {
  const float length = glm::length(way);
  return length > 1e-6f ? glm::vec2(way.y, -way.x) / length : glm::vec2(0.0f);
}

void join(std::vector<std::uint32_t>& indices, std::size_t begun, std::size_t end) {
  for (std::size_t i = begun; i < end; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    if (i == begun && !indices.empty()) {
      indices.push_back(indices.back());
      indices.push_back(index);
    }
    indices.push_back(index);
  }
}

void add_ribbon(Ribbons& to, const std::vector<EdgePoint>& line, bool closed, float wide) {
  const std::vector<EdgePoint> points = divided(line, closed);
  const std::size_t n = points.size();
  if (n < 2) return;
  const std::vector<glm::vec2> normals = normals_of(points, closed);
  const auto byte = [](float v) { return static_cast<std::int8_t>(std::lround(127.0f * v)); };
  for (const int axis : {0, 1}) {
    const auto takes = [&](std::size_t i) { return std::abs(normals[i][axis]) >= kOblique; };
    // Begin between two parts.
    std::size_t first = 0;
    while (closed && first < n && takes(first)) ++first;
    const bool whole = first == n;
    if (whole) first = 0;
    std::size_t begun = to.corners.size();
    for (std::size_t k = 0; k < n + (whole ? 1 : 0); ++k) {
      const std::size_t i = (first + k) % n;
      if (!takes(i)) {
        join(to.indices, begun, to.corners.size());
        begun = to.corners.size();
        continue;
      }
      const EdgePoint& p = points[i];
      const float along = normals[i][axis];
      glm::vec2 out(0.0f);
      out[axis] = 1.0f / along;
      for (const float beyond : {std::max(std::min(wide, p.most_out), kSoft),
                                 -std::max(std::min(wide, p.most_in), kSoft)})
        to.corners.push_back(
            {p.at + beyond * out,
             beyond,
             p.metres,
             p.strip,
             {byte(normals[i].x), byte(normals[i].y), byte(p.narrow ? 1.0f : 0.0f), 0}});
    }
    join(to.indices, begun, to.corners.size());
  }
}

}  // namespace onggi::render
