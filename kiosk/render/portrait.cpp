#include "kiosk/render/portrait.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace onggi::render {
namespace {

using Point = std::array<float, 3>;

// Area-weighted means of the faces' normals.
std::vector<Point> normals_of(const TriangleMesh& mesh) {
  std::vector<Point> out(mesh.positions.size(), Point{0, 0, 0});
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    for (const std::uint32_t corner : t) {
      for (std::size_t k = 0; k < 3; ++k) out[corner][k] += n[k];
    }
  }
  for (Point& n : out) {
    const float l = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (l > 0) n = {n[0] / l, n[1] / l, n[2] / l};
  }
  return out;
}

TriangleMesh standing(const TriangleMesh& mesh) {
  TriangleMesh out = mesh;
  if (out.positions.empty()) return out;
  Point low = out.positions[0], high = low;
  for (const Point& p : out.positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  for (Point& p : out.positions) {
    p = {p[0] - 0.5f * (low[0] + high[0]), p[1] - low[1], p[2] - 0.5f * (low[2] + high[2])};
  }
  if (out.normals.size() != out.positions.size()) out.normals = normals_of(out);
  return out;
}

}  // namespace

Levels levels_of(const TriangleMesh& mesh) {
  Levels levels;
  float top = 0;
  for (const Point& p : mesh.positions) top = std::max(top, p[1]);
  levels.height = std::max(top, 1e-4f);
  const auto level_at = [&](float y) {
    const float t = y / static_cast<float>(levels.height) * kLevels;
    return std::clamp(static_cast<int>(t), 0, kLevels - 1);
  };
  // Edges, not only corners: a long triangle crosses levels that hold none of its corners.
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t ia = t[k], ib = t[(k + 1) % 3];
      const Point &a = mesh.positions[ia], &b = mesh.positions[ib];
      const Point& n = mesh.normals[ia];
      const bool inward = n[0] * a[0] + n[2] * a[2] < -0.2f * std::hypot(a[0], a[2]);
      const int from = level_at(std::min(a[1], b[1])), to = level_at(std::max(a[1], b[1]));
      for (int l = from; l <= to; ++l) {
        const float y =
            (static_cast<float>(l) + 0.5f) * static_cast<float>(levels.height) / kLevels;
        const float rise = b[1] - a[1];
        const float s = std::abs(rise) > 1e-6f ? std::clamp((y - a[1]) / rise, 0.0f, 1.0f) : 0.0f;
        const float rho = std::hypot(a[0] + s * (b[0] - a[0]), a[2] + s * (b[2] - a[2]));
        auto& into = inward ? levels.inner : levels.outer;
        into[static_cast<std::size_t>(l)] = std::max(into[static_cast<std::size_t>(l)], rho);
      }
    }
  }
  for (std::size_t l = 0; l < kLevels; ++l) {
    levels.inner[l] = std::min(levels.inner[l], levels.outer[l]);
  }
  return levels;
}

Portrait portrait_of(const TriangleMesh& mesh, int width, int height) {
  const TriangleMesh model = standing(mesh);
  Portrait out;
  out.levels = levels_of(model);
  std::vector<float> vertices;
  vertices.reserve(model.positions.size() * 6);
  float radius = 1e-4f;
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    const Point &p = model.positions[i], &n = model.normals[i];
    vertices.insert(vertices.end(), {p[0], p[1], p[2], n[0], n[1], n[2]});
    radius = std::max(radius, std::hypot(p[0], p[2]));
  }
  out.mesh = Mesh(vertices.data(), vertices.size(),
                  model.triangles.empty() ? nullptr : model.triangles[0].data(),
                  model.triangles.size() * 3, {3, 3});
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  out.camera = view::frame_pot(width, height, {0.13f * w, 0.06f * h, 0.74f * w, 0.84f * h},
                               out.levels.height, radius);
  return out;
}

}  // namespace onggi::render
