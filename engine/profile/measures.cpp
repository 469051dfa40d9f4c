#include "engine/profile/measures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {

namespace {

/// Heights at which outlines are compared: midpoints of equal slices. 512 slices of a 0.3 m vessel
/// are 0.6 mm each, finer than a clay row.
constexpr int kSlices = 512;
/// Places that a wall may stand higher or lower by without being another wall: 0.6 % of the height.
constexpr std::size_t kShift = 3;
constexpr double kGivenBack = 1.25;
/// Rims and foot rings are rounded; callipers rest on their widest part, this near the end.
constexpr double kEnd = 0.015;
/// The wall is measured above the corner with the floor and below the rounding of the rim.
constexpr double kAboveFloor = 0.06;
constexpr double kBelowRim = 0.03;

/// The way in begins at the belly, but no lower and no higher than these shares of the height.
constexpr double kWayInLow = 0.5, kWayInHigh = 0.75;
/// A vessel that is less open than this has a lid or a stopper, or was not seen into.
constexpr double kLidded = 0.3;

double widest_between(const Profile& p, double low, double high) {
  double widest = std::max(p.outer_at(low), p.outer_at(high));
  for (const ProfilePoint& point : p.points)
    if (point.height > low && point.height < high) widest = std::max(widest, point.outer);
  return widest;
}

double way_in_from(const Dimensions& d) {
  return std::clamp(d.belly_height, kWayInLow * d.height, kWayInHigh * d.height);
}

/// The least share of the outer radius that is open, from `low` up.
double opening_above(const Profile& p, double low) {
  double least = p.inner_at(low) / p.outer_at(low);
  for (const ProfilePoint& point : p.points)
    if (point.height > low) least = std::min(least, point.inner / point.outer);
  return least;
}

void measure_wall(const Profile& p, Dimensions& d) {
  const double low = p.floor_height() + kAboveFloor * d.height;
  const double high = d.height * (1.0 - kBelowRim);
  if (low >= high) return;
  const double dh = (high - low) / kSlices;
  double sum = 0.0, sum_squares = 0.0;
  int count = 0;
  for (int i = 0; i < kSlices; ++i) {
    const double h = low + (i + 0.5) * dh;
    const double inner = p.inner_at(h);
    if (inner <= 0.0) continue;
    // A wall that leans is thinner than its horizontal section by the cosine of the lean.
    const double half = 0.01 * d.height;
    const double lean = (p.outer_at(h + half) + p.inner_at(h + half) - p.outer_at(h - half) -
                         p.inner_at(h - half)) /
                        (4.0 * half);
    const double thickness = (p.outer_at(h) - inner) / std::sqrt(1.0 + lean * lean);
    sum += thickness;
    sum_squares += thickness * thickness;
    ++count;
  }
  if (count == 0) return;
  d.wall_mean = sum / count;
  const double variance = std::max(0.0, sum_squares / count - d.wall_mean * d.wall_mean);
  d.wall_evenness = std::clamp(1.0 - std::sqrt(variance) / d.wall_mean, 0.0, 1.0);
}

/// A profile seen through a factor, without a copy of it.
struct Scaled {
  const Profile& profile;
  double factor;
  double height() const { return profile.height() * factor; }
  /// 0 above the rim: there is no wall to compare with.
  double outer(double h) const {
    // The rim itself is wall, also where a scale has rounded its height down.
    return h > height() * (1.0 + 1e-9) ? 0.0 : factor * profile.outer_at(h / factor);
  }
};

/// Outer radii at the ends and at the middles of the slices between.
using Radii = std::array<double, kSlices + 2>;

/// How far `value` lies outside of what `radii` are within kShift places of `at`.
double outside(double value, const Radii& radii, std::size_t at) {
  const std::size_t first = at > kShift ? at - kShift : 0;
  const std::size_t last = std::min(at + kShift, radii.size() - 1);
  double low = radii[first], high = radii[first];
  for (std::size_t i = first + 1; i <= last; ++i) {
    low = std::min(low, radii[i]);
    high = std::max(high, radii[i]);
  }
  return std::max({0.0, value - high, low - value});
}

/// The distance of two outlines at place `i` that is no matter of a hair up or down. On a slope the
/// window takes a little off every distance; at most the distance itself gives it back.
double firm_at(const Radii& a, const Radii& b, std::size_t i) {
  const double firm = std::max(outside(a[i], b, i), outside(b[i], a, i));
  return std::min(std::abs(a[i] - b[i]), kGivenBack * firm);
}

/// The largest such distance; and in `m` that of the places up to `shared`, `dh` apart.
double firm_worst(const Radii& goal, const Radii& pot, double shared, double dh, Measures& m) {
  double worst = 0.0;
  for (std::size_t i = 0; i < goal.size(); ++i) {
    const double firm = firm_at(goal, pot, i);
    worst = std::max(worst, firm);
    const double h = std::clamp((static_cast<double>(i) - 0.5) * dh, 0.0, kSlices * dh);
    if (h > shared || firm <= m.common_firm) continue;
    m.common_firm = firm;
    m.common_firm_at = h;
    m.common_firm_sign = pot[i] > goal[i] ? 1.0 : -1.0;
  }
  return worst;
}

/// An outline walked at even steps of its own length, and how it turns on the way.
constexpr int kSteps = 96, kChord = kSteps / 12;
using Turning = std::array<double, kSteps + 1>;

Turning turning_of(const Scaled& p) {
  constexpr int kFine = 512;
  std::array<Vec2, kFine + 1> line;
  std::array<double, kFine + 1> way{};
  for (std::size_t i = 0; i <= kFine; ++i) {
    const double h = p.height() * static_cast<double>(i) / kFine;
    line[i] = {p.factor * p.profile.outer_at(h / p.factor), h};
    if (i > 0) way[i] = way[i - 1] + length(line[i] - line[i - 1]);
  }
  std::array<Vec2, kSteps + 1> even;
  std::size_t at = 1;
  for (std::size_t k = 0; k <= kSteps; ++k) {
    const double wanted = way[kFine] * static_cast<double>(k) / kSteps;
    while (at < kFine && way[at] < wanted) ++at;
    const double t = (wanted - way[at - 1]) / (way[at] - way[at - 1]);
    even[k] = line[at - 1] + (line[at] - line[at - 1]) * std::clamp(t, 0.0, 1.0);
  }
  Turning out{};
  for (std::size_t k = kChord; k + kChord <= kSteps; ++k) {
    const Vec2 a = even[k] - even[k - kChord], b = even[k + kChord] - even[k];
    out[k] = portable::atan2(a.x * b.y - a.y * b.x, dot(a, b));
  }
  return out;
}

double turning_apart(const Scaled& a, const Scaled& b) {
  const Turning ta = turning_of(a), tb = turning_of(b);
  double squares = 0.0;
  for (std::size_t k = kChord; k + kChord <= kSteps; ++k)
    squares += (ta[k] - tb[k]) * (ta[k] - tb[k]);
  return std::sqrt(squares / (kSteps - 2 * kChord + 1));
}

Dimensions scaled(Dimensions d, double factor) {
  for (double* length : {&d.height, &d.belly, &d.belly_height, &d.mouth, &d.neck, &d.neck_height,
                         &d.foot, &d.wall_mean})
    *length *= factor;
  return d;
}

}  // namespace

Dimensions dimensions(const Profile& p) {
  Dimensions d;
  d.height = p.height();
  double belly_radius = 0.0;
  for (const ProfilePoint& point : p.points)
    if (point.outer > belly_radius) {
      belly_radius = point.outer;
      d.belly_height = point.height;
    }
  d.belly = 2.0 * belly_radius;
  d.foot = 2.0 * widest_between(p, 0.0, kEnd * d.height);
  d.mouth = 2.0 * widest_between(p, d.height * (1.0 - kEnd), d.height);

  // The neck lies between belly and lip; where nothing narrows, it is the mouth itself.
  double neck = d.mouth / 2.0;
  d.neck_height = d.height;
  for (const ProfilePoint& point : p.points)
    if (point.height > d.belly_height && point.height < d.height * (1.0 - kEnd) &&
        point.outer < neck) {
      neck = point.outer;
      d.neck_height = point.height;
    }
  d.neck = 2.0 * neck;
  if (p.inner_wall == InnerWall::measured) d.opening = opening_above(p, way_in_from(d));

  measure_wall(p, d);
  return d;
}

Measures compare(const Profile& target, const Profile& made, bool scale_free) {
  Measures m;
  m.scale = scale_free ? target.height() / made.height() : 1.0;
  m.out_of_round = m.scale * made.out_of_round;
  const Scaled goal{target, 1.0};
  const Scaled pot{made, m.scale};
  const double top = std::max(goal.height(), pot.height());
  const double dh = top / kSlices;

  double common = 0.0, either = 0.0, squares = 0.0;
  double common_volume = 0.0, either_volume = 0.0;
  const double shared = std::min(goal.height(), pot.height());
  const auto look = [&](double h, double a, double b) {
    const double apart = std::abs(b - a), sign = b > a ? 1.0 : -1.0;
    if (apart > m.outline_worst) {
      m.outline_worst = apart;
      m.outline_worst_at = h / goal.height();
      m.outline_worst_sign = sign;
    }
  };
  Radii goal_radii{}, pot_radii{};
  for (int i = 0; i < kSlices; ++i) {
    const double h = (i + 0.5) * dh;
    const double a = goal.outer(h);
    const double b = pot.outer(h);
    goal_radii[static_cast<std::size_t>(i) + 1] = a;
    pot_radii[static_cast<std::size_t>(i) + 1] = b;
    common += std::min(a, b);
    either += std::max(a, b);
    common_volume += std::min(a, b) * std::min(a, b);
    either_volume += std::max(a, b) * std::max(a, b);
    squares += (a - b) * (a - b);
    look(h, a, b);
  }
  for (const double h : {0.0, shared}) look(h, goal.outer(h), pot.outer(h));
  goal_radii.front() = goal.outer(0.0);
  pot_radii.front() = pot.outer(0.0);
  goal_radii.back() = goal.outer(top);
  pot_radii.back() = pot.outer(top);
  m.outline_worst_firm = firm_worst(goal_radii, pot_radii, shared, dh, m) / goal.height();
  m.common_firm /= goal.height();
  m.common_firm_at /= goal.height();
  m.outline_overlap = either > 0.0 ? common / either : 1.0;
  m.outline_rms = std::sqrt(squares / kSlices) / goal.height();
  m.outline_worst /= goal.height();
  m.volume_overlap = either_volume > 0.0 ? common_volume / either_volume : 1.0;
  m.turning_rms = turning_apart(goal, pot);
  m.target = dimensions(target);
  Dimensions pot_own = dimensions(made);
  // The pot's own belly may be anywhere: it is asked for a way in where the vessel has one.
  if (made.inner_wall == InnerWall::measured)
    pot_own.opening = opening_above(made, way_in_from(m.target) / m.scale);
  m.made = scaled(pot_own, m.scale);
  if (m.target.opening >= kLidded && made.inner_wall == InnerWall::measured)
    m.opening_lacking = std::max(0.0, 1.0 - m.made.opening / m.target.opening);
  return m;
}

}  // namespace onggi
