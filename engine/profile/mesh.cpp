#include "engine/profile/mesh.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/math/unit.h"

namespace onggi {

namespace {

/// cos(40 degrees): a drawn corner sharper than this keeps an edge that catches the light.
constexpr double kSmoothCos = 0.76604444311897801;

/// Out of the material, which lies to the left of the way from foot to rim to floor.
Vec2 normal_of(Vec2 from, Vec2 to) {
  const Vec2 d = unit(to - from);
  return {d.y, -d.x};
}

/// One circle of vertices, or a single one on the axis.
struct Ring {
  Vec2 at;
  Vec2 normal;
  std::uint32_t first = 0;
};

std::array<float, 3> as_floats(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

}  // namespace

TriangleMesh revolve(const Section& section, int sectors) {
  TriangleMesh mesh;
  std::vector<Vec2> outline;
  for (const Vec2& p : section.outline)
    if (outline.empty() || !(p == outline.back())) outline.push_back(p);
  if (outline.size() < 2 || sectors < 3) return mesh;

  const auto n = static_cast<std::uint32_t>(sectors);
  std::vector<Vec2> turn;
  turn.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * portable::kPi * i / n;
    turn.push_back({portable::cos(angle), portable::sin(angle)});
  }

  // Rings, a pair of them at a corner so that each side keeps its own normal.
  const auto add_ring = [&](Vec2 at, Vec2 normal) {
    Ring ring{at, normal, static_cast<std::uint32_t>(mesh.positions.size())};
    if (at.x == 0.0) {
      mesh.positions.push_back(as_floats(0, at.y, 0));
      mesh.normals.push_back(as_floats(0, normal.y < 0.0 ? -1.0 : 1.0, 0));
      return ring;
    }
    for (const Vec2& t : turn) {
      mesh.positions.push_back(as_floats(at.x * t.x, at.y, at.x * t.y));
      mesh.normals.push_back(as_floats(normal.x * t.x, normal.y, normal.x * t.y));
    }
    return ring;
  };
  const auto add_band = [&](const Ring& a, const Ring& b) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      if (a.at.x != 0.0) {
        const std::uint32_t tip = b.at.x == 0.0 ? b.first : b.first + i;
        mesh.triangles.push_back({a.first + i, tip, a.first + j});
      }
      if (b.at.x != 0.0) {
        const std::uint32_t tip = a.at.x == 0.0 ? a.first : a.first + j;
        mesh.triangles.push_back({tip, b.first + i, b.first + j});
      }
    }
  };

  Ring below = add_ring(outline[0], normal_of(outline[0], outline[1]));
  for (std::size_t k = 1; k < outline.size(); ++k) {
    const Vec2 before = normal_of(outline[k - 1], outline[k]);
    const bool last = k + 1 == outline.size();
    const Vec2 after = last ? before : normal_of(outline[k], outline[k + 1]);
    const bool smooth = dot(before, after) >= kSmoothCos;
    const Ring above = add_ring(outline[k], smooth ? unit(before + after) : before);
    add_band(below, above);
    below = smooth || last ? above : add_ring(outline[k], after);
  }
  return mesh;
}

Section section_of(const Profile& p) {
  Section section;
  auto& outline = section.outline;
  outline.push_back({0.0, 0.0});
  for (const ProfilePoint& point : p.points) outline.push_back({point.outer, point.height});
  for (auto point = p.points.rbegin(); point != p.points.rend() && point->inner > 0.0; ++point)
    outline.push_back({point->inner, point->height});
  outline.push_back({0.0, outline.back().y});
  return section;
}

}  // namespace onggi
