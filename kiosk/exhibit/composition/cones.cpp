#include "kiosk/exhibit/composition/cones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::exhibit {

namespace {

/// The line through a zone by its principal axis.
Cone fitted(std::span<const Vec2> outline, std::size_t first, std::size_t last) {
  Cone cone{first, last, {}, {}, 0.0};
  const double count = static_cast<double>(last - first + 1);
  for (std::size_t n = first; n <= last; ++n) cone.at = cone.at + (1.0 / count) * outline[n];
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t n = first; n <= last; ++n) {
    const Vec2 off = outline[n] - cone.at;
    xx += off.x * off.x, xy += off.x * off.y, yy += off.y * off.y;
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  cone.along = {std::cos(angle), std::sin(angle)};
  if (dot(cone.along, outline[last] - outline[first]) < 0.0) cone.along = -1.0 * cone.along;
  for (std::size_t n = first; n <= last; ++n)
    cone.error = std::max(cone.error, std::abs(cross(cone.along, outline[n] - cone.at)));
  return cone;
}

}  // namespace

std::vector<Cone> cones_of(std::span<const Vec2> outline, double tolerance, int most) {
  const std::size_t count = outline.size();
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto at = [count](std::size_t from, std::size_t to) { return from * count + to; };
  std::vector<double> error(count * count, kNever);
  for (std::size_t from = 0; from + 1 < count; ++from)
    for (std::size_t to = from + 1; to < count; ++to)
      error[at(from, to)] = fitted(outline, from, to).error;
  // worst[z][n]: of the best division of the points up to n into z + 1 zones.
  std::vector<std::vector<double>> worst(1);
  std::vector<std::vector<std::size_t>> begins(1, std::vector<std::size_t>(count, 0));
  for (std::size_t n = 0; n < count; ++n) worst[0].push_back(error[at(0, n)]);
  while (worst.back().back() > tolerance && static_cast<int>(worst.size()) < most) {
    std::vector<double> next(count, kNever);
    std::vector<std::size_t> begin(count, 0);
    for (std::size_t n = 1; n < count; ++n)
      for (std::size_t cut = 1; cut < n; ++cut) {
        const double here = std::max(worst.back()[cut], error[at(cut, n)]);
        if (here < next[n]) next[n] = here, begin[n] = cut;
      }
    // More zones than there is outline for.
    if (!(next.back() < worst.back().back())) break;
    worst.push_back(std::move(next));
    begins.push_back(std::move(begin));
  }
  std::vector<Cone> cones;
  std::size_t last = count - 1;
  for (std::size_t z = worst.size(); z-- > 0;) {
    const std::size_t first = z == 0 ? 0 : begins[z][last];
    cones.push_back(fitted(outline, first, last));
    last = first;
  }
  std::ranges::reverse(cones);
  return cones;
}

std::vector<Vec2> evenly_along(std::span<const Vec2> outline, std::size_t points) {
  std::vector<double> way{0.0};
  for (std::size_t n = 1; n < outline.size(); ++n)
    way.push_back(way.back() + length(outline[n] - outline[n - 1]));
  std::vector<Vec2> out;
  std::size_t k = 0;
  for (std::size_t n = 0; n < points; ++n) {
    const double at = way.back() * static_cast<double>(n) / static_cast<double>(points - 1);
    while (k + 2 < way.size() && way[k + 1] < at) ++k;
    const double step = way[k + 1] - way[k];
    const double part = step > 0.0 ? std::clamp((at - way[k]) / step, 0.0, 1.0) : 0.0;
    out.push_back((1.0 - part) * outline[k] + part * outline[k + 1]);
  }
  return out;
}

}  // namespace onggi::exhibit
