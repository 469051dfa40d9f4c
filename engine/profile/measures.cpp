#include "engine/profile/measures.h"

#include <algorithm>
#include <cmath>

namespace onggi {

namespace {

/// Heights at which outlines are compared: midpoints of equal slices. 512 slices of a 0.3 m vessel
/// are 0.6 mm each, finer than a clay row.
constexpr int kSlices = 512;
/// Rims and foot rings are rounded; callipers rest on their widest part, this near the end.
constexpr double kEnd = 0.015;
/// The wall is measured above the corner with the floor and below the rounding of the rim.
constexpr double kAboveFloor = 0.06;
constexpr double kBelowRim = 0.03;

double widest_between(const Profile& p, double low, double high) {
  double widest = std::max(p.outer_at(low), p.outer_at(high));
  for (const ProfilePoint& point : p.points)
    if (point.height > low && point.height < high) widest = std::max(widest, point.outer);
  return widest;
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
    return h > height() ? 0.0 : factor * profile.outer_at(h / factor);
  }
};

Dimensions scaled(Dimensions d, double factor) {
  for (double* length :
       {&d.height, &d.belly, &d.belly_height, &d.mouth, &d.neck, &d.foot, &d.wall_mean})
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
  for (const ProfilePoint& point : p.points)
    if (point.height > d.belly_height && point.height < d.height * (1.0 - kEnd))
      neck = std::min(neck, point.outer);
  d.neck = 2.0 * neck;

  measure_wall(p, d);
  return d;
}

Measures compare(const Profile& target, const Profile& made, bool scale_free) {
  Measures m;
  m.scale = scale_free ? target.height() / made.height() : 1.0;
  const Scaled goal{target, 1.0};
  const Scaled pot{made, m.scale};
  const double top = std::max(goal.height(), pot.height());
  const double dh = top / kSlices;

  double common = 0.0, either = 0.0, squares = 0.0, worst = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double h = (i + 0.5) * dh;
    const double a = goal.outer(h);
    const double b = pot.outer(h);
    common += std::min(a, b);
    either += std::max(a, b);
    squares += (a - b) * (a - b);
    if (std::abs(b - a) > worst) {
      worst = std::abs(b - a);
      m.outline_worst_at = h / goal.height();
      m.outline_worst_sign = b > a ? 1.0 : -1.0;
    }
  }
  m.outline_overlap = either > 0.0 ? common / either : 1.0;
  m.outline_rms = std::sqrt(squares / kSlices) / goal.height();
  m.outline_worst = worst / goal.height();
  m.target = dimensions(target);
  m.made = scaled(dimensions(made), m.scale);
  return m;
}

}  // namespace onggi
