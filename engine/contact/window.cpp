#include "engine/contact/window.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

double axis_distance(Vec3 p) { return std::sqrt(p.x * p.x + p.z * p.z); }

// Nearest distance to the axis on the straight way between two places.
double nearest_to_axis(Vec3 a, Vec3 b) {
  const double dx = b.x - a.x;
  const double dz = b.z - a.z;
  const double square = dx * dx + dz * dz;
  if (square == 0.0) return axis_distance(a);
  const double t = std::clamp(-(a.x * dx + a.z * dz) / square, 0.0, 1.0);
  return axis_distance({a.x + t * dx, 0.0, a.z + t * dz});
}

}  // namespace

double cross_section(double radius, double dy) noexcept {
  const double off = std::fabs(dy);
  return off < radius ? std::sqrt((radius - off) * (radius + off)) : -1.0;
}

Window::Window(const Clay& clay, Vec3 from, Vec3 to, double radius) noexcept
    : nearest_(nearest_to_axis(from, to)),
      per_radian_(clay.sectors() / (2.0 * portable::kPi)),
      sectors_(clay.sectors()),
      all_blocks_(clay.stride() / 8),
      first_row_(clay.first_row_above(std::min(from.y, to.y) - radius)),
      end_row_(clay.first_row_above(std::max(from.y, to.y) + radius)) {
  const double start = portable::atan2(from.z, from.x);
  turn_ = portable::atan2(to.z, to.x) - start;
  if (turn_ > portable::kPi) turn_ -= 2.0 * portable::kPi;
  if (turn_ < -portable::kPi) turn_ += 2.0 * portable::kPi;
  middle_ = start + 0.5 * turn_;
  half_per_section_ = nearest_ > radius ? portable::asin(radius / nearest_) / radius
                                        : 0.5 * portable::kPi / std::max(nearest_, 1e-12);
}

int Window::blocks(double section, BlockRange (&ranges)[2]) const noexcept {
  if (section < 0.0) return 0;
  ranges[0] = {0, all_blocks_};
  if (section >= nearest_) return 1;  // the axis is inside the section: the full circle, once

  // The row's own half angle is asin(section / nearest). The arcsine is convex and 0 at 0, so the
  // widest row's angle in proportion is never too small, and costs no trigonometry.
  const double half = half_per_section_ * section + 0.5 * std::fabs(turn_);
  if (half >= portable::kPi) return 1;
  // Two whole turns added keep the figures positive, where casting is flooring. One element more on
  // each side covers the rounding of the angles.
  const int turns = 2 * sectors_;
  int first = static_cast<int>((middle_ - half) * per_radian_ - 0.5 + turns) - 1 - turns;
  int last = static_cast<int>((middle_ + half) * per_radian_ - 0.5 + turns) + 2 - turns;
  if (last - first + 1 >= sectors_) return 1;
  const int shift = first < 0 ? sectors_ : first >= sectors_ ? -sectors_ : 0;
  first += shift;
  last += shift;
  if (last < sectors_) {
    ranges[0] = {first / 8, last / 8 + 1};
    return 1;
  }
  ranges[0] = {first / 8, all_blocks_};
  ranges[1] = {0, (last - sectors_) / 8 + 1};
  if (ranges[1].end <= ranges[0].begin) return 2;
  ranges[0] = {0, all_blocks_};  // the two ends meet in one block
  return 1;
}

}  // namespace onggi
