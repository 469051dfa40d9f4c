#include "engine/contact/paper_model.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kFullTurn = 2.0 * portable::kPi;

// Elements whose angle (studio frame) lies in eq. 2's interval: `count` elements from `first`.
struct Interval {
  int first = 0;
  int count = 0;
};

Interval eq2(Vec3 at, double radius, double wheel_angle, int sectors) {
  const double d = axis_distance(at);
  const double middle = 0.5 * portable::kPi - portable::asin(at.x / d);  // acos: 0..pi only
  if (!std::isfinite(middle)) return {};  // d = 0, and 0/0 selects nothing
  const double half = radius / d;
  if (!(half < portable::kPi)) return {0, sectors};
  const double from = middle - half - wheel_angle;
  const double to = middle + half - wheel_angle;
  const double per_radian = sectors / kFullTurn;
  const int first = static_cast<int>(std::ceil(from * per_radian - 0.5));
  const int last = static_cast<int>(std::floor(to * per_radian - 0.5));
  const int count = std::clamp(last - first + 1, 0, sectors);
  return {((first % sectors) + sectors) % sectors, count};
}

// A row of elements against the sphere, clay frame. Computes once what the elements share, and
// computes the direction, with its divisions, only on contact. Anybody who wants these equations to
// be fast would write them so; the corrected model's speed is compared with this
// (tests/bench/README.md).
struct Row {
  WallSide mode;
  Vec3 h;
  double d;
  double dy;
  double r;         // of the section; NaN if there is none
  double r_square;  // r r, not H_r H_r - dy dy: as printed in the paper
};

// The names are the paper's.
struct Collision {
  double p = 0;       // eqs. 3, 4
  double l = 0;       // eq. 5
  double held = 0;    // distance of E or M along the element's line
  double length = 0;  // of H - E or H - M
};

// False without contact.
bool collide(const Row& row, double s_r, double cos, double sin, Collision& c) {
  const double off = row.h.z * cos - row.h.x * sin;
  const double square = row.r_square - off * off;
  if (!(square >= 0.0)) return false;  // the line does not meet the section: there is no E
  const double along = row.h.x * cos + row.h.z * sin;
  const double half_chord = std::sqrt(square);
  const bool outside = row.mode == WallSide::outside;

  // The line C-S meets the section at two points. E1 is the nearer to C. If the section contains
  // the axis, the nearer point may lie behind the axis.
  const double reach = outside ? std::fabs(std::fabs(along) - half_chord)  // ||E - C||
                               : std::fabs(along) + half_chord;
  const auto distance = [&](double held) {
    return length(Vec3{row.h.x - held * cos, row.dy, row.h.z - held * sin});
  };
  if (outside ? s_r < row.d : s_r > row.d) {  // a point
    c.p = outside ? s_r - reach : reach - s_r;
    if (!(c.p > 0.0)) return false;
    const double e1 = along - half_chord;
    const double e2 = along + half_chord;
    c.held = (std::fabs(e2) < std::fabs(e1)) == outside ? e2 : e1;
    c.length = distance(c.held);
  } else {  // a line, with M the middle of E1 and E2
    c.held = along;
    c.length = distance(along);
    c.p = row.r - c.length;  // r lies in the row's plane, H - M does not
    if (!(c.p > 0.0)) return false;
  }
  c.l = s_r - reach;
  return true;
}

}  // namespace

PaperModel::PaperModel(const Clay& clay) {
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
  const Interval window = eq2(at, radius, wheel_angle, clay.sectors());
  const int first_row = clay.first_row_above(at.y - radius);  // eq. 1
  const int end_row = clay.first_row_above(at.y + radius);

  PaperTouch out;
  Vec3 sum;
  for (int j = first_row; j < end_row; ++j) {
    float* const outer = clay.outer_mut(j).data();
    float* const inner = clay.inner_mut(j).data();
    const double dy = h.y - clay.row_height(j);
    const double r = std::sqrt(radius * radius - dy * dy);
    const Row row{mode, h, d, dy, r, r * r};
    bool moved = false;
    // To the end of the circle, then on from its start.
    for (int begin = window.first, left = window.count; left > 0; begin = 0) {
      const int end = std::min(begin + left, clay.sectors());
      left -= end - begin;
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
        const double s_r = double{outer[i]};
        Collision hit;
        if (!collide(row, s_r, cos_[i], sin_[i], hit)) continue;
        const Vec3 away{h.x - hit.held * cos_[i], dy, h.z - hit.held * sin_[i]};
        const Vec3 f{away.x / hit.length, away.y / hit.length, away.z / hit.length};  // eq. 8
        sum += (c.c_v * hit.p) * f;                                                   // eq. 9
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
