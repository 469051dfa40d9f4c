#include "kiosk/picture/render/portrait.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace onggi::render {
namespace {

using Point = std::array<float, 3>;

constexpr float kPictured = 0.2f;  // metres, the largest side

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
  // Every vessel is pictured at the same size, so that light and shadow are the same for a cup and
  // a jar.
  const float widest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-6f});
  const float to = kPictured / widest;
  for (Point& p : out.positions) {
    p = {(p[0] - 0.5f * (low[0] + high[0])) * to, (p[1] - low[1]) * to,
         (p[2] - 0.5f * (low[2] + high[2])) * to};
  }
  return out;
}

GLint wrap_of(content::Coloring::Wrap wrap) {
  return wrap == content::Coloring::Wrap::clamp    ? GL_CLAMP_TO_EDGE
         : wrap == content::Coloring::Wrap::mirror ? GL_MIRRORED_REPEAT
                                                   : GL_REPEAT;
}

/// Rows and v both start at the top: the first row is at v = 0, as glTF defines it.
Texture texture_of(const content::Coloring::Picture& picture) {
  const auto& pixels = *picture.pixels;
  // With alpha, because OpenGL ES has no mipmap levels for sRGB without it.
  std::vector<std::uint8_t> rgba(pixels.rgb.size() / 3 * 4, 255);
  for (std::size_t from = 0, to = 0; to < rgba.size(); from += 3, to += 4)
    std::copy_n(&pixels.rgb[from], 3, &rgba[to]);
  Texture out = Texture::create(GL_SRGB8_ALPHA8, pixels.width, pixels.height, GL_RGBA,
                                GL_UNSIGNED_BYTE, rgba.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(picture.across));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(picture.down));
  return out;
}

Texture plain_white() {
  constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};
  return Texture::create(GL_SRGB8_ALPHA8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kWhite.data());
}

/// The triangles' corners, sorted by coat, otherwise in their own order.
std::vector<std::uint32_t> sort_by_coat(const TriangleMesh& mesh, const content::Coloring& coloring,
                                        std::vector<Coat>& coats) {
  const auto coat_of = [&](const std::array<std::uint32_t, 3>& triangle) {
    return coloring.picture.empty() ? std::size_t{0} : coloring.picture[triangle[0]];
  };
  std::vector<std::size_t> at(coloring.pictures.size() + 1, 0);
  for (const auto& t : mesh.triangles) at[coat_of(t)] += 3;
  std::size_t first = 0;
  for (std::size_t p = 0; p < at.size(); ++p) {
    const std::size_t size = std::exchange(at[p], first);
    if (size > 0)
      coats.push_back({p == 0 ? plain_white() : texture_of(coloring.pictures[p - 1]),
                       static_cast<int>(first), static_cast<int>(size)});
    first += size;
  }
  std::vector<std::uint32_t> indices(first);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t corner : t) indices[at[coat_of(t)]++] = corner;
  return indices;
}

/// The lowest upward-facing surface around the axis, ignoring a fiftieth of the area, which may be
/// pits. It is the floor of an open vessel with a well in its middle, or the top of a closed one.
/// The vessel's lowest point if nothing faces up.
float floor_of(const TriangleMesh& mesh, float widest, float top) {
  std::vector<std::pair<float, double>> seen;  // height, area from above
  double all = 0;
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Point m{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    if (mesh.normals[t[0]][1] < 0.6f || std::hypot(m[0], m[2]) > 0.5f * widest) continue;
    const double area = std::abs(
        static_cast<double>((c[0] - a[0]) * (b[2] - a[2]) - (b[0] - a[0]) * (c[2] - a[2])));
    seen.emplace_back(m[1], area);
    all += area;
  }
  std::sort(seen.begin(), seen.end());
  double below = 0;
  for (const auto& [height, area] : seen)
    if ((below += area) > 0.02 * all) return height;
  return top;
}

}  // namespace

Levels levels_of(const TriangleMesh& mesh) {
  Levels levels;
  float top = 0;
  for (const Point& p : mesh.positions) top = std::max(top, p[1]);
  levels.height = std::max(top, 1e-4f);
  const auto step = static_cast<float>(levels.height) / kLevels;
  const auto level_at = [step](float y) {
    return std::clamp(static_cast<int>(y / step), 0, kLevels - 1);
  };
  // Means weighted by area. The outer wall comes first: a handle is small, and its parts that face
  // the axis from outside the outer wall are not inner wall.
  for (const bool inward : {false, true}) {
    std::array<float, kLevels> sum{}, weight{};
    auto& into = inward ? levels.inner : levels.outer;
    for (const auto& t : mesh.triangles) {
      const Point &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
      const Point& n = mesh.normals[t[0]];
      const Point m{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
      const float rho = std::hypot(m[0], m[2]);
      // A flat foot or lid has all radii at one height, so it tells nothing about the wall.
      if (std::abs(n[1]) > 0.93f) continue;
      if ((n[0] * m[0] + n[2] * m[2] < -0.1f * rho) != inward) continue;
      const float area = std::hypot((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]),
                                    (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                                    (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]));
      for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const int from = level_at(std::min(p[1], q[1])), to = level_at(std::max(p[1], q[1]));
        for (int l = from; l <= to; ++l) {
          // Where the edge crosses the level's middle.
          const float y = (static_cast<float>(l) + 0.5f) * step, rise = q[1] - p[1];
          const float s = std::abs(rise) > 1e-6f ? std::clamp((y - p[1]) / rise, 0.0f, 1.0f) : 0.5f;
          const float at = std::hypot(p[0] + s * (q[0] - p[0]), p[2] + s * (q[2] - p[2]));
          const auto k = static_cast<std::size_t>(l);
          if (inward && at > levels.outer[k]) continue;
          const float w = (area / static_cast<float>(to - from + 1) + 1e-12f) * (0.0004f + at * at);
          sum[k] += w * at;
          weight[k] += w;
        }
      }
    }
    for (std::size_t k = 0; k < kLevels; ++k) into[k] = weight[k] > 0 ? sum[k] / weight[k] : 0.0f;
    if (inward) continue;
    // Levels without an outer wall (flat feet, flat lips) take the nearest one's.
    for (std::size_t k = 1; k < kLevels; ++k) into[k] = into[k] > 0 ? into[k] : into[k - 1];
    for (std::size_t k = kLevels - 1; k > 0; --k) {
      into[k - 1] = into[k - 1] > 0 ? into[k - 1] : into[k];
    }
  }
  // A plate is open from its floor up, although no part of it is steep enough for an inner wall.
  const float widest = *std::max_element(levels.outer.begin(), levels.outer.end());
  float above = 0.98f * levels.outer[kLevels - 1];
  for (int l = kLevels - 1; l >= level_at(floor_of(mesh, widest, top)); --l) {
    float& inner = levels.inner[static_cast<std::size_t>(l)];
    if (inner <= 0) inner = above;
    above = inner;
  }
  return levels;
}

Model model_of(const TriangleMesh& mesh, std::array<float, 3> color,
               const content::Coloring& coloring, float size) {
  std::array<float, 256> light;
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = content::light_of(static_cast<std::uint8_t>(i));
  TriangleMesh sized = mesh;
  for (Point& p : sized.positions)
    for (float& x : p) x *= size;
  if (sized.normals.size() != sized.positions.size()) sized.normals = normals_of(sized);
  Model out;
  out.levels = levels_of(sized);
  std::vector<float> vertices;
  vertices.reserve(sized.positions.size() * 11);
  out.radius = 1e-4f;
  for (std::size_t i = 0; i < sized.positions.size(); ++i) {
    const Point &p = sized.positions[i], &n = sized.normals[i];
    Point c = color;
    std::array<float, 2> place{};
    if (!coloring.empty())
      for (std::size_t k = 0; k < 3; ++k) c[k] = light[coloring.colors[i][k]];
    if (!coloring.places.empty()) place = coloring.places[i];
    vertices.insert(vertices.end(),
                    {p[0], p[1], p[2], n[0], n[1], n[2], c[0], c[1], c[2], place[0], place[1]});
    out.radius = std::max(out.radius, std::hypot(p[0], p[2]));
  }
  const std::vector<std::uint32_t> indices = sort_by_coat(sized, coloring, out.coats);
  out.mesh = Mesh(vertices.data(), vertices.size(), indices.data(), indices.size(), {3, 3, 3, 2});
  return out;
}

Portrait portrait_of(const TriangleMesh& mesh, std::array<float, 3> color,
                     const content::Coloring& coloring, int width, int height) {
  Portrait out;
  out.model = model_of(standing(mesh), color, coloring, 1.0f);
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  out.camera = view::frame_pot(width, height, {0.13f * w, 0.06f * h, 0.74f * w, 0.84f * h},
                               out.model.levels.height, out.model.radius);
  return out;
}

}  // namespace onggi::render
