#include "kiosk/collection/score/likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"
#include "engine/math/vec.h"

namespace onggi::score {
namespace {

/// Even steps along the outline; no good scan has finer points in its wall.
constexpr int kSteps = 512;
/// Heights at which the wall is sampled, so that a scan's ripple between them gives no direction.
constexpr int kHeights = 128;

using Directions = std::array<double, kSteps>;

std::vector<Vec2> outline_of(const Profile& p) {
  std::vector<Vec2> line{{0.0, 0.0}};
  for (int i = 0; i <= kHeights; ++i) {
    const double h = p.height() * i / kHeights;
    line.push_back({p.outer_at(h), h});
  }
  line.push_back({0.0, p.height()});
  return line;
}

/// The turning function's mean over each of kSteps even steps of length.
Directions directions_of(const Profile& p) {
  const std::vector<Vec2> line = outline_of(p);
  double whole = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) whole += length(line[i] - line[i - 1]);
  Directions out{};
  double behind = 0.0;  // in steps
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 way = line[i] - line[i - 1];
    const double end = std::min<double>(behind + length(way) / whole * kSteps, kSteps);
    const double direction = portable::atan2(way.y, way.x);
    for (auto k = static_cast<std::size_t>(behind); k < kSteps && static_cast<double>(k) < end;
         ++k) {
      const double from = std::max(behind, static_cast<double>(k));
      const double to = std::min(end, static_cast<double>(k + 1));
      out[k] += std::max(0.0, to - from) * direction;
    }
    behind = end;
  }
  return out;
}

double apart(const Directions& a, const Directions& b) {
  double squares = 0.0;
  for (std::size_t k = 0; k < kSteps; ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(squares / kSteps);
}

double likeness_of(double apart) { return 100.0 / (1.0 + apart / (0.25 * portable::kPi)); }

}  // namespace

double turning_apart(const Profile& a, const Profile& b) {
  return apart(directions_of(a), directions_of(b));
}

double likeness(const Profile& a, const Profile& b) { return likeness_of(turning_apart(a, b)); }

std::optional<std::size_t> most_alike(const Profile& to, std::span<const Profile* const> among) {
  std::optional<std::size_t> best;
  double most = kAlikeEnough;
  const Directions wanted = directions_of(to);  // once, not for each of a shelf
  for (std::size_t i = 0; i < among.size(); ++i) {
    if (among[i] == nullptr || among[i] == &to || among[i]->points.size() < 2) continue;
    const double alike = likeness_of(apart(wanted, directions_of(*among[i])));
    if (alike < most || (best && alike == most)) continue;
    most = alike;
    best = i;
  }
  return best;
}

}  // namespace onggi::score
