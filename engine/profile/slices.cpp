#include "engine/profile/slices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/portable.h"

namespace onggi {

namespace {

Vec3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& p = mesh.positions[i];
  return {p[0], p[1], p[2]};
}

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

AxisFrame axis_frame(Vec3 origin, Vec3 direction) {
  AxisFrame f;
  f.origin = origin;
  f.up = direction * (1.0 / length(direction));
  // Start from the file's axis that is furthest from `up`, so that no product is near zero.
  const double x = std::abs(f.up.x), y = std::abs(f.up.y), z = std::abs(f.up.z);
  const Vec3 aside = x <= y && x <= z ? Vec3{1, 0, 0} : z <= y ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 across = aside - f.up * dot(aside, f.up);
  f.across = across * (1.0 / length(across));
  f.along = onggi::cross(f.across, f.up);
  return f;
}

Slicer::Slicer(const TriangleMesh& mesh, const AxisFrame& frame) : mesh_(&mesh) {
  const std::size_t n = mesh.positions.size();
  plane_.resize(n);
  height_.resize(n);
  lowest_ = std::numeric_limits<double>::max();
  highest_ = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p = at(mesh, i) - frame.origin;
    plane_[i] = {dot(p, frame.across), dot(p, frame.along)};
    height_[i] = dot(p, frame.up);
  }
  for (const auto& t : mesh.triangles)  // vertices that no triangle uses have no height
    for (const std::uint32_t i : t) {
      lowest_ = std::min(lowest_, height_[i]);
      highest_ = std::max(highest_, height_[i]);
    }
}

std::vector<std::vector<CutSegment>> Slicer::cut(std::span<const double> heights) const {
  std::vector<std::vector<CutSegment>> out(heights.size());
  if (heights.empty()) return out;
  // Both triangles at an edge must find the same point, so an edge always runs upwards.
  const auto point = [&](std::uint32_t i, std::uint32_t j, double h) {
    if (height_[i] > height_[j] || (height_[i] == height_[j] && i > j)) std::swap(i, j);
    const double t = (h - height_[i]) / (height_[j] - height_[i]);
    return plane_[i] + (plane_[j] - plane_[i]) * t;
  };
  for (const auto& t : mesh_->triangles) {
    const double h0 = height_[t[0]], h1 = height_[t[1]], h2 = height_[t[2]];
    const double low = std::min({h0, h1, h2}), high = std::max({h0, h1, h2});
    auto first = std::upper_bound(heights.begin(), heights.end(), low);
    if (first == heights.end() || *first > high) continue;
    // The surface's normal, seen in the plane: (p1 - p0) x (p2 - p0), its parts across and along.
    const Vec2 a = plane_[t[1]] - plane_[t[0]], b = plane_[t[2]] - plane_[t[0]];
    const double ah = h1 - h0, bh = h2 - h0;
    // across x up = along reversed: (x, h, z) is right-handed with h as the second axis.
    const Vec2 facing{ah * b.y - a.y * bh, a.x * bh - ah * b.x};
    for (auto h = first; h != heights.end() && *h <= high; ++h) {
      const bool up0 = h0 >= *h, up1 = h1 >= *h, up2 = h2 >= *h;
      if (up0 == up1 && up1 == up2) continue;
      CutSegment s;
      s.facing = facing;
      if (up0 != up1 && up0 != up2) {
        s.a = point(t[0], t[1], *h);
        s.b = point(t[0], t[2], *h);
      } else if (up1 != up0 && up1 != up2) {
        s.a = point(t[1], t[0], *h);
        s.b = point(t[1], t[2], *h);
      } else {
        s.a = point(t[2], t[0], *h);
        s.b = point(t[2], t[1], *h);
      }
      out[static_cast<std::size_t>(h - heights.begin())].push_back(s);
    }
  }
  return out;
}

std::vector<Vec2> ray_directions(int rays) {
  std::vector<Vec2> out;
  for (int k = 0; k < rays; ++k) {
    const double angle = (k + 0.5) * 2.0 * portable::kPi / rays;
    out.push_back({portable::cos(angle), portable::sin(angle)});
  }
  return out;
}

std::vector<std::vector<Crossing>> crossings(std::span<const CutSegment> outline, Vec2 centre,
                                             std::span<const Vec2> rays) {
  const auto n = static_cast<long>(rays.size());
  std::vector<std::vector<Crossing>> out(rays.size());
  const double per_turn = static_cast<double>(n) / (2.0 * portable::kPi);
  for (const CutSegment& s : outline) {
    const Vec2 a = s.a - centre, b = s.b - centre;
    double from = portable::atan2(a.y, a.x) * per_turn - 0.5;
    double to = portable::atan2(b.y, b.x) * per_turn - 0.5;
    // Seen from the centre a straight piece spans less than half a turn.
    const double turn = static_cast<double>(n);
    if (to - from > turn / 2) to -= turn;
    if (from - to > turn / 2) from -= turn;
    if (from > to) std::swap(from, to);
    for (auto k = static_cast<long>(std::ceil(from)); static_cast<double>(k) < to; ++k) {
      const auto ray = static_cast<std::size_t>(((k % n) + n) % n);
      const Vec2 d = rays[ray];
      const double ca = cross(d, a), cb = cross(d, b);
      if (ca == cb) continue;
      const double t = ca / (ca - cb);
      const double radius = dot(d, a + (b - a) * t);
      if (radius > 0.0) out[ray].push_back({radius, dot(d, s.facing) > 0.0});
    }
  }
  for (auto& ray : out)
    std::sort(ray.begin(), ray.end(), [](const Crossing& a, const Crossing& b) {
      return a.radius != b.radius ? a.radius > b.radius : a.outward > b.outward;
    });
  return out;
}

Agreement agreement(std::vector<double>& values, std::size_t all, double share) {
  Agreement best;
  const auto wanted =
      std::max<std::size_t>(2, static_cast<std::size_t>(share * static_cast<double>(all)));
  if (values.size() < wanted) return best;
  std::sort(values.begin(), values.end());
  for (std::size_t i = 0; i + wanted <= values.size(); ++i) {
    const double low = values[i], high = values[i + wanted - 1];
    if (!best.found || high - low < best.high - best.low) best = {low, high, true};
  }
  return best;
}

}  // namespace onggi
