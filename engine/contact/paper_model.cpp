#include "engine/contact/paper_model.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kFullTurn = 2.0 * portable::kPi;

// Elements whose angle, in the studio's frame, lies in eq. 2's interval: `count` from `first` on.
struct Interval {
  int first = 0;
  int count = 0;
};

Interval eq2(Vec3 at, double radius, double wheel_angle, int sectors, AngleReading reading) {
  const double d = axis_distance(at);
  const double middle = 0.5 * portable::kPi - portable::asin(at.x / d);  // acos: 0..pi only
  if (!std::isfinite(middle)) return {};  // d = 0, and 0/0 selects nothing
  // 1e4 is 1600 times round: beyond it an index would not hold the count.
  const double half = std::min(radius / d, 1e4);
  double from = middle - half;
  double to = middle + half;
  if (reading == AngleReading::each_once && !(half < portable::kPi)) return {0, sectors};
  if (reading == AngleReading::unwrapped) {
    from = std::max(from, 0.0);
    to = std::min(to, kFullTurn);
  }
  const double per_radian = sectors / kFullTurn;
  const int first = static_cast<int>(std::ceil((from - wheel_angle) * per_radian - 0.5));
  const int last = static_cast<int>(std::floor((to - wheel_angle) * per_radian - 0.5));
  int count = std::max(last - first + 1, 0);
  if (reading != AngleReading::index_range) count = std::min(count, sectors);
  return {((first % sectors) + sectors) % sectors, count};
}

// One element against the sphere, clay frame. Names are the paper's.
struct Collision {
  double p = 0;  // eqs. 3, 4
  double l = 0;  // eq. 5
  Vec3 f;        // eq. 8
};

Collision collide(WallSide mode, Vec3 h, double h_r, double d, double s_r, double s_h, double cos,
                  double sin) {
  const double dy = h.y - s_h;
  const double r = std::sqrt(h_r * h_r - dy * dy);
  const double along = h.x * cos + h.z * sin;
  const double off = h.z * cos - h.x * sin;
  const double half_chord = std::sqrt(r * r - off * off);
  if (!(half_chord >= 0.0)) return {};  // the line does not meet the section: there is no E

  // The line C-S meets the section at two points; E1 is the nearer to C. With the axis within the
  // section, "nearer" may be the one behind the axis.
  double e1 = along - half_chord;
  double e2 = along + half_chord;
  if (std::fabs(e2) < std::fabs(e1)) std::swap(e1, e2);
  const double e = mode == WallSide::outside ? e1 : e2;
  const double reach = std::fabs(e);  // ||E - C||

  const bool point = mode == WallSide::outside ? s_r < d : s_r > d;
  const double held = point ? e : along;  // M is the middle of E1 and E2
  const Vec3 away{h.x - held * cos, dy, h.z - held * sin};
  const double distance = length(away);
  Collision c;
  if (point)
    c.p = mode == WallSide::outside ? s_r - reach : reach - s_r;
  else
    c.p = r - distance;  // r lies in the row's plane, H - M does not
  c.l = s_r - reach;
  c.f = {away.x / distance, away.y / distance, away.z / distance};
  return c;
}

}  // namespace

PaperModel::PaperModel(const Clay& clay, AngleReading reading) : reading_(reading) {
  for (int i = 0; i < clay.sectors(); ++i) {
    const double angle = (i + 0.5) * kFullTurn / clay.sectors();
    cos_.push_back(portable::cos(angle));
    sin_.push_back(portable::sin(angle));
  }
}

WallSide PaperModel::mode(const Clay& clay, Vec3 at, double wheel_angle, SideWish wish) noexcept {
  if (wish == SideWish::outside) return WallSide::outside;
  if (wish == SideWish::inside) return WallSide::inside;
  const int row = std::clamp(clay.first_row_above(at.y), 0, clay.rows() - 1);
  const double turns = (portable::atan2(at.z, at.x) - wheel_angle) / kFullTurn;
  const double part = turns - std::floor(turns);
  const int sector = std::clamp(static_cast<int>(part * clay.sectors()), 0, clay.sectors() - 1);
  const double surface = double{clay.outer(row)[static_cast<std::size_t>(sector)]};
  return axis_distance(at) < surface ? WallSide::inside : WallSide::outside;
}

PaperTouch PaperModel::tick(Clay& clay, WallSide mode, Vec3 at, double radius, double wheel_angle,
                            double turn, const PaperCoefficients& c) const noexcept {
  const ClayDef& def = clay.def();
  const double d = axis_distance(at);
  const double turn_cos = portable::cos(wheel_angle);
  const double turn_sin = portable::sin(wheel_angle);
  const Vec3 h{at.x * turn_cos + at.z * turn_sin, at.y, at.z * turn_cos - at.x * turn_sin};
  const Interval window = eq2(at, radius, wheel_angle, clay.sectors(), reading_);
  const int first_row = clay.first_row_above(at.y - radius);  // eq. 1
  const int end_row = clay.first_row_above(at.y + radius);

  PaperTouch out;
  Vec3 sum;
  for (int j = first_row; j < end_row; ++j) {
    const std::span<float> outer = clay.outer_mut(j);
    const std::span<float> inner = clay.inner_mut(j);
    bool moved = false;
    for (int n = 0; n < window.count; ++n) {
      const auto i = static_cast<std::size_t>((window.first + n) % clay.sectors());
      const double s_r = double{outer[i]};
      const Collision hit = collide(mode, h, radius, d, s_r, clay.row_height(j), cos_[i], sin_[i]);
      if (!(hit.p > 0.0)) continue;
      sum += (c.c_v * hit.p) * hit.f;  // eq. 9
      out.depth = std::max(out.depth, hit.p);
      out.depth_sum += hit.p;
      ++out.touched;
      // Eq. 6. The limits are the clay's, not the paper's.
      const double wanted = s_r - hit.l / c.c_eta;
      outer[i] =
          static_cast<float>(std::clamp(wanted, def.radius_min + def.wall_min, def.radius_max));
      inner[i] = std::min(inner[i], static_cast<float>(double{outer[i]} - def.wall_min));
      moved = true;
    }
    if (moved) clay.mark_dirty(j);
  }
  out.visited = std::int64_t{std::max(end_row - first_row, 0)} * window.count;
  out.resistance = {sum.x * turn_cos - sum.z * turn_sin, sum.y,
                    sum.z * turn_cos + sum.x * turn_sin};
  // Eq. 10, with t along the wheel's turn at the tool. On the axis it is 0/0.
  const double way = turn > 0.0 ? 1.0 : turn < 0.0 ? -1.0 : 0.0;
  const Vec3 t{-at.z / d * way, 0.0, at.x / d * way};
  out.force = out.resistance + (c.c_r * out.depth) * t;  // eq. 7
  return out;
}

Vec3 PaperFilter::filter(Vec3 force) noexcept {
  return {axis_[0].filter(force.x), axis_[1].filter(force.y), axis_[2].filter(force.z)};
}

void PaperFilter::settle() noexcept {
  for (Lowpass& axis : axis_) axis.settle(0.0);
}

std::array<double, 12> PaperFilter::memory() const noexcept {
  std::array<double, 12> all{};
  for (std::size_t n = 0; n < axis_.size(); ++n) {
    const std::array<double, 4> one = axis_[n].memory();
    std::ranges::copy(one, all.begin() + static_cast<std::ptrdiff_t>(4 * n));
  }
  return all;
}

}  // namespace onggi
