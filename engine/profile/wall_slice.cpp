#include "engine/profile/wall_slice.h"

#include <algorithm>
#include <cmath>

namespace onggi::extraction {

namespace {

/// At least this share of all rays must agree about a radius.
constexpr double kShare = 0.5;
/// Radii further than this share of the vessel's size from the agreed one are something else.
constexpr double kStandsOff = 0.025;
/// Scanned surfaces are rough: crossings this near to each other are one surface, met thrice.
constexpr double kRough = 0.008;

/// Mean of the values near the agreed radius, once those beyond three of their own deviations are
/// left out too.
struct Near {
  double mean = 0.0, spread = 0.0;
  int count = 0;
};
Near near(const std::vector<double>& values, double low, double high) {
  Near out;
  for (int pass = 0; pass < 3; ++pass) {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (const double v : values)
      if (v >= low && v <= high) {
        sum += v;
        squares += v * v;
        ++count;
      }
    if (count == 0) return out;
    out.mean = sum / count;
    out.spread = std::sqrt(std::max(0.0, squares / count - out.mean * out.mean));
    out.count = count;
    low = std::max(low, out.mean - 3.0 * out.spread - 1e-9);
    high = std::min(high, out.mean + 3.0 * out.spread + 1e-9);
  }
  return out;
}

/// The surface that begins with crossing `from`: the middle of an odd number of crossings that
/// stand within `rough` of each other. Moves `from` past them.
double surface(std::span<const Crossing> ray, std::size_t& from, double rough) {
  std::size_t last = from;
  while (last + 2 < ray.size() && ray[last].radius - ray[last + 2].radius < rough) last += 2;
  const double radius = ray[(from + last) / 2].radius;
  from = last + 1;
  return radius;
}

}  // namespace

WallSlice read_wall(const std::vector<CutSegment>& outline, RayCrossings& rays, double size,
                    bool facing_known) {
  WallSlice out;
  rays.meet(outline, {});
  const std::size_t n = rays.fan().count();
  const double rough = kRough * size;
  std::vector<double> outer;
  std::vector<std::size_t> behind(n, 0);
  std::vector<double> outer_of(n, 0.0);
  outer.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (rays.ray(k).empty()) continue;
    outer_of[k] = surface(rays.ray(k), behind[k], rough);
    outer.push_back(outer_of[k]);
  }
  out.present = static_cast<int>(outer.size());
  const Agreement mode = agreement(outer, n, kShare);
  if (!mode.found) return out;
  const double off = std::max(kStandsOff * size, 0.75 * (mode.high - mode.low));
  const double low = mode.middle() - off, high = mode.middle() + off;
  const Near wall = near(outer, low, high);
  if (mode.high - mode.low > 6.0 * kStandsOff * size) return out;  // they agree on nothing
  out.outer = wall.mean;
  out.spread = wall.spread;

  std::vector<double> inner;
  inner.reserve(n);
  int looked = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (outer_of[k] <= 0.0) continue;
    if (outer_of[k] < low || outer_of[k] > high) {
      ++out.masked;
      continue;
    }
    ++looked;
    // Behind the outer surface the next one that looks towards the axis is the inner wall.
    std::size_t next = behind[k];
    const auto ray = rays.ray(k);
    while (facing_known && next < ray.size() && ray[next].outward) ++next;
    if (next < ray.size()) inner.push_back(surface(ray, next, rough));
  }
  if (2 * inner.size() < static_cast<std::size_t>(looked)) return out;
  const Agreement inside = agreement(inner, inner.size(), kShare);
  if (!inside.found) return out;
  const double slack = std::max(kStandsOff * size, 0.75 * (inside.high - inside.low));
  const Near hollow = near(inner, inside.middle() - slack, inside.middle() + slack);
  if (hollow.mean < out.outer) out.inner = hollow.mean;
  return out;
}

}  // namespace onggi::extraction
