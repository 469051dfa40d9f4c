#include "kiosk/visit/decorating/zones.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace onggi::decorating {

namespace {
constexpr double kRow = 1e-6 * surface::kRowHeight;  // m
constexpr int kSlopeRows = 10;                       // each way: 2.5 mm
constexpr int kTurnRows = 20;                        // each way: 5 mm
constexpr double kTurns = 0.3;                       // rad
constexpr double kApart = 0.012;                     // m from a border to the next, and to the ends
}  // namespace

Zones::Zones(const surface::Surface& surface, double outside) : end_(outside) {
  const int rows = std::min(static_cast<int>(outside / kRow), surface.rows());
  const auto at = [&](int j) -> const surface::Row& {
    return surface.row(std::clamp(j, 0, rows - 1));
  };
  // Direction of the outline, rad, unwrapped along it.
  std::vector<double> way(static_cast<std::size_t>(std::max(rows, 0)));
  for (int j = 0; j < rows; ++j) {
    const surface::Row &low = at(j - kSlopeRows), &high = at(j + kSlopeRows);
    const double angle = std::atan2(high.height - low.height, high.radius - low.radius);
    const auto n = static_cast<std::size_t>(j);
    way[n] = j == 0 ? angle : way[n - 1] + std::remainder(angle - way[n - 1], 2 * 3.14159265358979);
  }
  std::vector<double> turn(way.size(), 0.0);
  for (int j = kTurnRows; j + kTurnRows < rows; ++j)
    turn[static_cast<std::size_t>(j)] = std::abs(way[static_cast<std::size_t>(j + kTurnRows)] -
                                                 way[static_cast<std::size_t>(j - kTurnRows)]);
  // The sharpest first.
  std::vector<int> order;
  for (int j = 0; j < rows; ++j)
    if (turn[static_cast<std::size_t>(j)] >= kTurns) order.push_back(j);
  std::ranges::stable_sort(order, [&](int a, int b) {
    return turn[static_cast<std::size_t>(a)] > turn[static_cast<std::size_t>(b)];
  });
  for (const int j : order) {
    const double here = kRow * (j + 0.5);
    const bool near = std::ranges::any_of(
        borders_, [&](double border) { return std::abs(border - here) < kApart; });
    if (!near && here > kApart && here < end_ - kApart) borders_.push_back(here);
  }
  std::ranges::sort(borders_);
}

double Zones::within(double at, double below, double above) const {
  if (at > end_) return at;  // inside
  const auto over = std::ranges::upper_bound(borders_, at);
  const double high = over == borders_.end() ? end_ : *over;
  const double low = over == borders_.begin() ? 0.0 : *std::prev(over);
  if (below + above > high - low) return at;
  const double moved = std::clamp(at, low + below, high - above);
  return std::abs(moved - at) <= kMost ? moved : at;
}

}  // namespace onggi::decorating
