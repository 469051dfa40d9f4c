#include "engine/profile/ends.h"

#include <algorithm>
#include <cmath>

#include "engine/profile/median.h"
#include "engine/profile/wall_slice.h"

namespace onggi::extraction {

namespace {

constexpr int kCoarse = 48;
/// A slice belongs to the body where this share of its circle is there.
constexpr double kCovered = 0.5;
/// A skin rougher than this share of the vessel's size has its ends measured by their middle.
constexpr double kRoughEnd = 0.003;
constexpr double kMostRough = 0.02;  ///< Of the height.
/// An end is judged by slices this many deviations inwards of its outermost bump.
constexpr double kNear = 4.0, kFar = 7.0;
/// An end with less of what lies inwards of it has no flat.
constexpr double kTapers = 0.25;
/// The outer part of an end, of its radius; and, of the vessel's size, where handles begin.
constexpr double kOuterPart = 0.7, kOutermost = 1.1;

/// How far neighbouring radii jump about, as the deviation of one of them. Sides, ovals and steps
/// leave most second differences near zero.
double roughness_of(const std::vector<double>& radii, std::vector<double>& jumps) {
  jumps.clear();
  const std::size_t n = radii.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double before = radii[k], here = radii[(k + 1) % n], after = radii[(k + 2) % n];
    if (before > 0.0 && here > 0.0 && after > 0.0)
      jumps.push_back(std::abs(before - 2.0 * here + after));
  }
  // Of a normal variable: the median of |x| is 0.6745 deviations, and 1 + 4 + 1 variances add up.
  constexpr double kToDeviation = 1.0 / (0.6745 * 2.449489742783178);
  return jumps.size() < n / 2 ? 0.0 : kToDeviation * median(jumps);
}

/// Material that a slice cuts between the radii `least` and `most`, as a mean over the rays of its
/// radii squared: from the outside in, every second crossing ends what the one before began.
double material(std::span<const CutSegment> outline, RayCrossings& rays, double least,
                double most) {
  rays.meet(outline, {});
  double sum = 0.0;
  for (std::size_t k = 0; k < rays.fan().count(); ++k) {
    double sign = 1.0;
    for (const Crossing& c : rays.ray(k)) {
      if (c.radius > most) continue;
      sum += sign * std::max(0.0, c.radius * c.radius - least * least);
      sign = -sign;
    }
  }
  return sum / static_cast<double>(rays.fan().count());
}

/// Where a rough flat end lies: bumps above its middle and hollows below it weigh the same, so half
/// of the material is left there. Only its outer part is asked, since a disc may hang on one corner
/// in the middle. `end` is the outermost bump, `inwards` +1 at the foot and -1 at the rim. An end
/// that tapers to a point stays where it is.
double middle_of_end(const Slicer& slicer, RayCrossings& rays, double end, double deviation,
                     double inwards, double most) {
  double least = 0.0;
  const auto material_at = [&](double depth) {
    const double h = end + inwards * depth;
    return material(slicer.cut(h), rays, least, most);
  };
  const double near = kNear * deviation, far = kFar * deviation;
  double whole = 0.0;
  const auto find_whole = [&] {
    const double above = material_at(near);
    whole = above - (material_at(far) - above) * near / (far - near);
    return whole >= kTapers * above && whole > 0.0;
  };
  const auto outermost = [&](double depth) {
    const double h = end + inwards * depth;
    rays.meet(slicer.cut(h), {});
    double sum = 0.0;
    for (std::size_t k = 0; k < rays.fan().count(); ++k)
      for (const Crossing& c : rays.ray(k))
        if (c.radius <= most) {
          sum += c.radius;
          break;
        }
    return sum / static_cast<double>(rays.fan().count());
  };
  if (!find_whole()) return end;
  const double edge = outermost(near);
  least = kOuterPart * std::min(edge, edge - (outermost(far) - edge) * near / (far - near));
  if (!find_whole()) return end;
  double outside = 0.0, inside = near;
  for (int i = 0; i < 10; ++i) {
    const double middle = 0.5 * (outside + inside);
    (material_at(middle) < 0.5 * whole ? outside : inside) = middle;
  }
  return end + inwards * inside;
}

}  // namespace

BodyEnds find_ends(const Slicer& slicer, RayCrossings& rays) {
  BodyEnds out;
  const std::size_t n = rays.fan().count();
  const double low = slicer.lowest(), high = slicer.highest();
  const double step = (high - low) / kCoarse;
  std::vector<double> heights;
  for (int i = 0; i < kCoarse; ++i) heights.push_back(low + (i + 0.5) * step);

  // How far the body reaches, how rough it is, and whether its surfaces know their outside.
  std::vector<double> reach, roughness, jumps;
  std::size_t outward = 0, all = 0;
  slicer.each_cut(heights, [&](std::size_t, std::span<const CutSegment> outline) {
    std::vector<double> radii, every(n, 0.0);
    rays.meet(outline, {});
    for (std::size_t k = 0; k < n; ++k) {
      if (rays.ray(k).empty()) continue;
      every[k] = rays.ray(k).front().radius;
      radii.push_back(every[k]);
      ++all;
      if (rays.ray(k).front().outward) ++outward;
    }
    const Agreement mode = agreement(radii, n, kCovered);
    if (!mode.found) return;
    reach.push_back(mode.middle());
    roughness.push_back(roughness_of(every, jumps));
  });
  if (reach.empty()) return out;
  out.size = *std::max_element(reach.begin(), reach.end());
  out.roughness = median(roughness);
  out.facing_known = static_cast<double>(outward) > 0.9 * static_cast<double>(all);

  const auto wall_at = [&](double h) {
    return read_wall(slicer.cut(h), rays, out.size, out.facing_known);
  };
  const auto is_body = [&](double h) {
    const WallSlice wall = wall_at(h);
    return wall.outer > 0.0 &&
           wall.present - wall.masked >= kCovered * static_cast<double>(rays.fan().count());
  };
  std::size_t first = 0, last = heights.size();
  while (first < last && !is_body(heights[first])) ++first;
  while (last > first && !is_body(heights[last - 1])) --last;
  if (first >= last) return out;
  const double hair = 0.002 * (high - low);
  const auto edge = [&](double inside, double outside) {
    // Most vessels end in a flat foot and an even rim.
    const double close = outside + (inside > outside ? hair : -hair);
    if ((outside == low || outside == high) && is_body(close)) return outside;
    for (int i = 0; i < 8; ++i) {
      const double middle = 0.5 * (inside + outside);
      (is_body(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  out.bottom = edge(heights[first], first == 0 ? low : heights[first - 1]);
  out.top = edge(heights[last - 1], last == heights.size() ? high : heights[last]);

  const double deviation = std::min(out.roughness, kMostRough * (out.top - out.bottom));
  if (deviation > kRoughEnd * out.size) {
    const double most = kOutermost * out.size;
    out.bottom = middle_of_end(slicer, rays, out.bottom, deviation, 1.0, most);
    out.top = middle_of_end(slicer, rays, out.top, deviation, -1.0, most);
  }
  return out;
}

}  // namespace onggi::extraction
