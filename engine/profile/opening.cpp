#include "engine/profile/opening.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/profile/median.h"

namespace onggi::extraction {

namespace {

constexpr int kGrid = 40;
/// Looks stay clear of the rim itself.
constexpr double kWithin = 0.8;
/// The deepest surface that is not a stray splinter: this share of the looks goes deeper.
constexpr double kDeepest = 0.03;
/// Where nothing stops this share of the looks there is no floor.
constexpr double kThrough = 0.5;
/// Looks along the axis, each way.
constexpr int kColumns = 9;

/// Draws every triangle into a square of `count` x `count` looks along the axis, `half` wide to
/// each side: look(x, y, height, turns) for each that it is under, `turns` twice its area in the
/// plane across the axis, with the sign of the way round.
template <typename Look>
void draw_into(const Slicer& slicer, double half, int count, const Look& look) {
  const double step = 2.0 * half / count;
  const auto first_at = [&](double low) {
    return static_cast<int>(std::clamp(std::ceil((low + half) / step - 0.5), 0.0, 1.0 * count));
  };
  for (const auto& t : slicer.mesh().triangles) {
    const Vec2 a = slicer.plane(t[0]), b = slicer.plane(t[1]), c = slicer.plane(t[2]);
    const double area = cross(b - a, c - a);
    if (area == 0.0) continue;
    const int x0 = first_at(std::min({a.x, b.x, c.x})), x1 = first_at(std::max({a.x, b.x, c.x}));
    const int y0 = first_at(std::min({a.y, b.y, c.y})), y1 = first_at(std::max({a.y, b.y, c.y}));
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const Vec2 p{(x + 0.5) * step - half, (y + 0.5) * step - half};
        const double wa = cross(b - p, c - p) / area, wb = cross(c - p, a - p) / area;
        const double wc = 1.0 - wa - wb;
        if (wa < 0.0 || wb < 0.0 || wc < 0.0) continue;
        look(x, y, wa * slicer.height(t[0]) + wb * slicer.height(t[1]) + wc * slicer.height(t[2]),
             area);
      }
  }
}

}  // namespace

EndView look_into(const Slicer& slicer, double bottom, double top, double radius, bool from_top) {
  EndView out;
  const double half = kWithin * radius, step = 2.0 * half / kGrid;
  const double height = top - bottom;
  if (!(half > 0.0) || !(height > 0.0)) return out;
  const double none = 1e300;
  std::vector<double> depth(static_cast<std::size_t>(kGrid) * kGrid, none);
  std::vector<bool> from_behind(depth.size(), false);

  draw_into(slicer, half, kGrid, [&](int x, int y, double h, double area) {
    const auto at = static_cast<std::size_t>(y) * kGrid + static_cast<std::size_t>(x);
    const double deep = from_top ? top - h : h - bottom;
    if (!(deep < depth[at])) return;
    depth[at] = deep;
    // across x along points down the axis, so that a surface that looks up turns to the right.
    from_behind[at] = (area > 0.0) == from_top;
  });

  std::vector<double> seen;
  double sum = 0.0;
  int looks = 0, through = 0, behind = 0;
  for (int y = 0; y < kGrid; ++y)
    for (int x = 0; x < kGrid; ++x) {
      const Vec2 p{(x + 0.5) * step - half, (y + 0.5) * step - half};
      if (dot(p, p) > half * half) continue;
      ++looks;
      const auto at = static_cast<std::size_t>(y) * kGrid + static_cast<std::size_t>(x);
      const double d = depth[at];
      if (d == none) ++through;
      if (from_behind[at]) ++behind;
      sum += d == none ? 1.0 : std::clamp(d / height, 0.0, 1.0);
      if (d != none) seen.push_back(d);
    }
  out.openness = sum / looks;
  out.through = static_cast<double>(through) / looks;
  out.behind = static_cast<double>(behind) / looks;
  if (out.through > kThrough) {
    out.floor = height;
  } else if (!seen.empty()) {
    std::sort(seen.begin(), seen.end());
    out.floor =
        seen[static_cast<std::size_t>((1.0 - kDeepest) * static_cast<double>(seen.size() - 1))];
  }
  return out;
}

Hollow find_hollow(const Slicer& slicer, double bottom, double top, double radius) {
  std::vector<std::vector<std::pair<double, bool>>> columns(kColumns * kColumns);
  draw_into(slicer, radius, kColumns, [&](int x, int y, double h, double area) {
    columns[static_cast<std::size_t>(y * kColumns + x)].push_back(
        {h, area < 0.0});  // looks up, as in look_into
  });
  std::vector<double> floors, ceilings;
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    Hollow best;
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!column[i].second) continue;
      const double floor = std::max(bottom, column[i].first);
      const double ceiling = i + 1 < column.size() ? std::min(top, column[i + 1].first) : top;
      if (ceiling - floor > best.ceiling - best.floor) best = {floor, ceiling};
    }
    if (best.ceiling <= best.floor) continue;
    floors.push_back(best.floor);
    ceilings.push_back(best.ceiling);
  }
  if (2 * floors.size() < columns.size()) return {};
  return {median(floors), median(ceilings)};
}

}  // namespace onggi::extraction
