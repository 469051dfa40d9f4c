#include "engine/profile/wall_slice.h"

#include <algorithm>
#include <cmath>

namespace onggi::extraction {

namespace {

/// At least this share of all rays must agree about a radius.
constexpr double kShare = 0.5;
/// As many are enough on a smaller and much truer circle: handles stand outside of a wall.
constexpr double kHidden = 0.3;
/// Radii further than this share of the vessel's size from the agreed one are something else.
constexpr double kStandsOff = 0.025;
/// What stands further off than this share of it says nothing about the circle's centre.
constexpr double kFarOff = 0.15;
/// Scanned surfaces are rough: crossings this near to each other are one surface, met thrice.
constexpr double kRough = 0.008;
/// What stands free inside, narrower than this share of the hollow, is a post or funnel, no wall.
constexpr double kPost = 0.5;

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

/// What lies behind the outer surface of a ray, of which `next` is the first crossing.
struct Behind {
  double inner = 0.0;  ///< Of the innermost wall, 0: none.
  int walls = 0;
};
Behind look_behind(std::span<const Crossing> ray, std::size_t next, double rough,
                   bool facing_known) {
  Behind out;
  if (!facing_known) {
    if (next < ray.size()) out = {surface(ray, next, rough), 1};
    return out;
  }
  for (;;) {
    // A wall ends with the next surface that looks towards the axis.
    while (next < ray.size() && ray[next].outward) ++next;
    if (next >= ray.size()) return out;
    out.inner = surface(ray, next, rough);
    ++out.walls;
    while (next < ray.size() && !ray[next].outward) ++next;
    if (next >= ray.size() || ray[next].radius < kPost * out.inner) return out;
  }
}

/// First and second harmonic of the radii, but for what stands far off.
void find_form(const std::vector<double>& outer_of, const RayFan& fan, double size,
               WallSlice& out) {
  double count = 0.0;
  for (std::size_t k = 0; k < outer_of.size(); ++k) {
    const double off = outer_of[k] - out.outer;
    if (outer_of[k] <= 0.0 || std::abs(off) > kFarOff * size) continue;
    const Vec2 d = fan.direction(k);
    out.centre = out.centre + d * off;
    out.oval = out.oval + Vec2{d.x * d.x - d.y * d.y, 2.0 * d.x * d.y} * off;
    count += 1.0;
  }
  if (count <= 0.0) return;
  out.centre = out.centre * (2.0 / count);
  out.oval = out.oval * (2.0 / count);
}

}  // namespace

WallSlice read_wall(std::span<const CutSegment> outline, RayCrossings& rays, double size,
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
  Agreement mode = agreement(outer, n, kShare);
  if (!mode.found) return out;
  // Where handles hide most of a circle, what agrees better further in is the wall.
  std::vector<double> further_in;
  for (const double r : outer)
    if (r < mode.low) further_in.push_back(r);
  const Agreement tight = agreement(further_in, n, kHidden);
  if (tight.found && tight.high - tight.low < kStandsOff * size &&
      tight.high - tight.low < 0.5 * (mode.high - mode.low))
    mode = tight;
  const double off = std::max(kStandsOff * size, 0.75 * (mode.high - mode.low));
  const double low = mode.middle() - off, high = mode.middle() + off;
  const Near wall = near(outer, low, high);
  if (mode.high - mode.low > 6.0 * kStandsOff * size) return out;  // they agree on nothing
  out.outer = wall.mean;
  out.spread = wall.spread;
  find_form(outer_of, rays.fan(), size, out);

  std::vector<double> inner;
  inner.reserve(n);
  int looked = 0, single = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (outer_of[k] <= 0.0) continue;
    if (outer_of[k] < low || outer_of[k] > high) {
      ++out.masked;
      if (outer_of[k] < low) ++out.within;
      continue;
    }
    ++looked;
    const Behind found = look_behind(rays.ray(k), behind[k], rough, facing_known);
    if (found.walls == 0) continue;
    inner.push_back(found.inner);
    if (found.walls == 1) ++single;
  }
  if (2 * inner.size() < static_cast<std::size_t>(looked)) return out;
  const Agreement inside = agreement(inner, inner.size(), kShare);
  if (!inside.found) return out;
  const double slack = std::max(kStandsOff * size, 0.75 * (inside.high - inside.low));
  const Near hollow = near(inner, inside.middle() - slack, inside.middle() + slack);
  if (hollow.mean < out.outer) out.inner = hollow.mean;
  out.one_wall = 2 * static_cast<std::size_t>(single) > inner.size();
  return out;
}

std::vector<WallSlice> read_walls(const Slicer& slicer, std::span<const double> heights,
                                  RayCrossings& rays, double size, bool facing_known) {
  std::vector<WallSlice> walls;
  slicer.each_cut(heights, [&](std::size_t, std::span<const CutSegment> outline) {
    walls.push_back(read_wall(outline, rays, size, facing_known));
  });
  return walls;
}

}  // namespace onggi::extraction
