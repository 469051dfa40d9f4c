#include "engine/profile/slices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/portable.h"
#include "engine/math/unit.h"

namespace onggi::extraction {

namespace {

/// An arc that rises by more than this share of its radius has its chord for a side: nine a turn.
constexpr double kHighestArc = 0.0625;

Vec3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& p = mesh.positions[i];
  return {p[0], p[1], p[2]};
}

/// Rises with the angle of p from 0 to 4 in a full turn.
double turn_of(Vec2 p) {
  const double part = p.y / (std::abs(p.x) + std::abs(p.y));
  if (p.x < 0.0) return 2.0 - part;
  return p.y < 0.0 ? 4.0 + part : part;
}

}  // namespace

AxisFrame axis_frame(Vec3 origin, Vec3 direction) {
  AxisFrame f;
  f.origin = origin;
  f.up = unit(direction);
  // Start from the file's axis that is furthest from `up`, so that no product is near zero.
  const double x = std::abs(f.up.x), y = std::abs(f.up.y), z = std::abs(f.up.z);
  const Vec3 aside = x <= y && x <= z ? Vec3{1, 0, 0} : z <= y ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  f.across = unit(aside - f.up * dot(aside, f.up));
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

void Slicer::cut_into(std::span<std::vector<CutSegment>> out,
                      std::span<const double> heights) const {
  // Both triangles at an edge must find the same point, so an edge always runs upwards.
  const auto point = [&](std::uint32_t i, std::uint32_t j, double h, Vec2 facing, double& bulge) {
    if (height_[i] > height_[j] || (height_[i] == height_[j] && i > j)) std::swap(i, j);
    const double t = (h - height_[i]) / (height_[j] - height_[i]);
    const Vec2 edge = plane_[j] - plane_[i];
    // The arc rises over the part of its chord that runs round the axis: across the facing.
    const double round = cross(facing, edge);
    bulge = 0.5 * t * (1.0 - t) * round * round;
    return plane_[i] + edge * t;
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
    const double size = length(facing);
    const Vec2 unit = size > 0.0 ? facing * (1.0 / size) : Vec2{};
    for (auto h = first; h != heights.end() && *h <= high; ++h) {
      const bool up0 = h0 >= *h, up1 = h1 >= *h, up2 = h2 >= *h;
      if (up0 == up1 && up1 == up2) continue;
      CutSegment s;
      s.facing = facing;
      if (up0 != up1 && up0 != up2) {
        s.a = point(t[0], t[1], *h, unit, s.bulge_a);
        s.b = point(t[0], t[2], *h, unit, s.bulge_b);
      } else if (up1 != up0 && up1 != up2) {
        s.a = point(t[1], t[0], *h, unit, s.bulge_a);
        s.b = point(t[1], t[2], *h, unit, s.bulge_b);
      } else {
        s.a = point(t[2], t[0], *h, unit, s.bulge_a);
        s.b = point(t[2], t[1], *h, unit, s.bulge_b);
      }
      out[static_cast<std::size_t>(h - heights.begin())].push_back(s);
    }
  }
}

std::vector<std::size_t> Slicer::counts_at(std::span<const double> heights) const {
  // One more from the first height that a triangle reaches, one less from the first that it does
  // not.
  std::vector<std::ptrdiff_t> change(heights.size() + 1);
  for (const auto& t : mesh_->triangles) {
    const double h0 = height_[t[0]], h1 = height_[t[1]], h2 = height_[t[2]];
    const auto first = std::upper_bound(heights.begin(), heights.end(), std::min({h0, h1, h2}));
    const auto end = std::upper_bound(first, heights.end(), std::max({h0, h1, h2}));
    ++change[static_cast<std::size_t>(first - heights.begin())];
    --change[static_cast<std::size_t>(end - heights.begin())];
  }
  std::vector<std::size_t> counts;
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    counts.push_back(static_cast<std::size_t>(count += change[i]));
  return counts;
}

std::vector<CutSegment> Slicer::cut(double height) const {
  std::vector<CutSegment> outline;
  cut_into(std::span(&outline, 1), std::span(&height, 1));
  return outline;
}

void Slicer::each_cut(std::span<const double> heights, const TakeOutline& take,
                      std::size_t most) const {
  const std::vector<std::size_t> counts = counts_at(heights);
  std::vector<std::vector<CutSegment>> outlines;
  for (std::size_t begin = 0, end = 0; begin < heights.size(); begin = end) {
    for (std::size_t held = 0; end < heights.size(); ++end) {
      held += counts[end];
      if (end > begin && held > most) break;
    }
    outlines.resize(std::max(outlines.size(), end - begin));
    for (std::size_t i = begin; i < end; ++i) {
      outlines[i - begin].clear();
      outlines[i - begin].reserve(counts[i]);
    }
    cut_into(outlines, heights.subspan(begin, end - begin));
    for (std::size_t i = begin; i < end; ++i) take(i, outlines[i - begin]);
  }
}

RayFan::RayFan(int count) {
  for (int k = 0; k < count; ++k) {
    const double angle = (k + 0.5) * 2.0 * portable::kPi / count;
    directions_.push_back({portable::cos(angle), portable::sin(angle)});
    turns_.push_back(turn_of(directions_.back()));
  }
  const std::size_t buckets = 4 * directions_.size();
  for (std::size_t i = 0; i <= buckets; ++i)
    from_turn_.push_back(static_cast<std::size_t>(
        std::lower_bound(turns_.begin(), turns_.end(),
                         4.0 * static_cast<double>(i) / static_cast<double>(buckets)) -
        turns_.begin()));
}

std::size_t RayFan::first_after(Vec2 p) const {
  const double turn = turn_of(p);
  const double bucket = turn * static_cast<double>(directions_.size());
  std::size_t ray = from_turn_[std::min(static_cast<std::size_t>(bucket), from_turn_.size() - 1)];
  while (ray > 0 && turns_[ray - 1] >= turn) --ray;
  while (ray < turns_.size() && turns_[ray] < turn) ++ray;
  return ray;
}

/// Every crossing, in the order of the outline: take(ray, radius, dot of the ray and the facing).
template <class Take>
void RayCrossings::each(std::span<const CutSegment> outline, Vec2 centre, const Take& take) const {
  const std::size_t n = fan_->count();
  for (const CutSegment& s : outline) {
    Vec2 a = s.a - centre, b = s.b - centre;
    // Seen from the centre a straight piece spans less than half a turn; let it run to the left.
    const double side = cross(a, b);
    if (side == 0.0) continue;
    double bulge_a = s.bulge_a, bulge_b = s.bulge_b;
    if (side < 0.0) {
      std::swap(a, b);
      std::swap(bulge_a, bulge_b);
    }
    const double chord = dot(b - a, b - a);
    const std::size_t last = fan_->first_after(b) % n;
    for (std::size_t k = fan_->first_after(a) % n; k != last; k = k + 1 == n ? 0 : k + 1) {
      const Vec2 d = fan_->direction(k);
      const double ca = cross(d, a), cb = cross(d, b);
      if (ca == cb) continue;
      const double share = ca / (ca - cb);
      const double flat = dot(d, a + (b - a) * share);
      if (!(flat > 0.0)) continue;
      // The corners of the mesh lie on a surface of revolution, and between them it bulges by arcs.
      // Without this a coarse mesh comes out narrower than what it was made from.
      const double bulge =
          (1.0 - share) * bulge_a + share * bulge_b + 0.5 * share * (1.0 - share) * chord;
      take(k, flat + std::min(bulge / flat, kHighestArc * flat), dot(d, s.facing));
    }
  }
}

std::span<const double> RayCrossings::outermost(std::span<const CutSegment> outline, Vec2 centre) {
  furthest_.assign(fan_->count(), 0.0);
  each(outline, centre, [this](std::size_t k, double radius, double) {
    furthest_[k] = std::max(furthest_[k], radius);
  });
  return furthest_;
}

void RayCrossings::meet(std::span<const CutSegment> outline, Vec2 centre) {
  const std::size_t n = fan_->count();
  met_.clear();
  begin_.assign(n + 1, 0);
  each(outline, centre, [this](std::size_t k, double radius, double facing) {
    met_.push_back({k, {radius, facing > 0.0}});
    ++begin_[k + 1];
  });
  for (std::size_t k = 0; k < n; ++k) begin_[k + 1] += begin_[k];
  next_.assign(begin_.begin(), begin_.end() - 1);
  sorted_.resize(met_.size());
  for (const auto& [k, crossing] : met_) sorted_[next_[k]++] = crossing;
  for (std::size_t k = 0; k < n; ++k)
    std::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(begin_[k]),
              sorted_.begin() + static_cast<std::ptrdiff_t>(begin_[k + 1]),
              [](const Crossing& a, const Crossing& b) {
                return a.radius != b.radius ? a.radius > b.radius : a.outward > b.outward;
              });
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

}  // namespace onggi::extraction
