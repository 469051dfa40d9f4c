#include "engine/contact/bodies/bounds.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/bodies/ball.h"
#include "engine/math/portable.h"

namespace onggi::body {
Circle Outline::circle() const noexcept {
  if (round < 0.0f) return {};
  const double sum = length(Vec2{double{ux} + double{vx}, double{uz} + double{vz}});
  const double difference = length(Vec2{double{ux} - double{vx}, double{uz} - double{vz}});
  const Circle block{double{x}, double{z}, std::max(sum, difference) + double{round}};
  if (!(oval > 0.0f)) return block;
  const double longest = std::sqrt(double{oval} * double{oval} + double{oval_ax} * double{oval_ax} +
                                   double{oval_az} * double{oval_az});
  return longest < block.radius ? Circle{double{oval_x}, double{oval_z}, longest} : block;
}

double Approach::nearest(double y) const noexcept {
  constexpr double kSlack = 1e-6;  // m: rows and their faces are floats
  const double up = y - level;
  const Vec2 middle = at + up * lean;
  const double away = length(middle);
  if (away < 1e-9) return -1e9;
  const double chord = cross_section(radius, std::max(std::fabs(up) - half, 0.0) / rise);
  const double side = std::max(chord, 0.0) * std::fabs(dot(across, middle));
  return away - kSlack - round - (std::fabs(dot(through, middle)) + side) / away;
}

Turn turn_of(const Hull& hull, Vec3 at) noexcept {
  constexpr double kAllRound = portable::kPi;
  const double base = portable::atan2(at.z, at.x);
  const double c = portable::cos(base);
  const double s = portable::sin(base);
  double low = 0.0;
  double high = 0.0;
  for (int n = 0; n < hull.count; ++n) {
    const Vec3 p = hull.middle[static_cast<std::size_t>(n)];
    const double away = axis_distance(p);
    if (away <= hull.radius) return {base, kAllRound};
    const double angle = portable::atan2(c * p.z - s * p.x, c * p.x + s * p.z);
    const double half = hull.radius > 0.0 ? portable::asin(hull.radius / away) : 0.0;
    low = std::min(low, angle - half);
    high = std::max(high, angle + half);
  }
  // Balls within half a turn: the axis lies outside their hull.
  if (high - low >= portable::kPi) return {base, kAllRound};
  return {base + 0.5 * (low + high), 0.5 * (high - low)};
}

AxisReach reach_of(const Hull& hull, Vec3 at) noexcept {
  constexpr double kSlack = 1e-6;  // m: rows and their faces are floats
  const double away = axis_distance(at);
  AxisReach reach{1e9, 0.0};
  for (int n = 0; n < hull.count; ++n) {
    const Vec3 p = hull.middle[static_cast<std::size_t>(n)];
    // A point's distance from the axis is at least its distance in any one direction.
    const double along = away > 0.0 ? (p.x * at.x + p.z * at.z) / away : 0.0;
    reach.nearest = std::min(reach.nearest, along);
    reach.farthest = std::max(reach.farthest, axis_distance(p));
  }
  return {reach.nearest - hull.radius - kSlack, reach.farthest + hull.radius + kSlack};
}

Turn turn_of(const Outline& o, WallSide side, double extent, const Turn& coarse) noexcept {
  constexpr double kSlack = 1e-6;  // m: outlines are floats
  const double away = length(Vec2{double{o.x}, double{o.z}});
  const double u = length(Vec2{double{o.ux}, double{o.uz}});
  const double v = length(Vec2{double{o.vx}, double{o.vz}});
  const double round = double{o.round};
  if (away < 1e-6 || std::max(u, v) <= 2.0 * round + 1e-9) return coarse;
  // The parallelogram, its rounded corners made square, in a frame whose x axis goes through its
  // middle. Its thin side may be only rounding error.
  const double rx = double{o.x} / away;
  const double rz = double{o.z} / away;
  const auto turned = [&](double x, double z) { return Vec2{x * rx + z * rz, z * rx - x * rz}; };
  const Vec2 first = turned(double{o.ux}, double{o.uz});
  const Vec2 second = turned(double{o.vx}, double{o.vz});
  const Vec2 a = u > 1e-9 ? (1.0 + round / u) * first : (round / v) * Vec2{-second.y, second.x};
  const Vec2 b = v > 1e-9 ? (1.0 + round / v) * second : (round / u) * Vec2{-first.y, first.x};
  const Vec2 middle{away, 0.0};
  const Vec2 corner[4] = {middle + a + b, middle + a - b, middle - a - b, middle - a + b};

  const bool outside = side == WallSide::outside;
  const double limit = outside ? extent + kSlack : std::max(extent - kSlack, 0.0);
  // Most rows of a tool held in front of the wall end here.
  if (outside && away - std::fabs(a.x) - std::fabs(b.x) > limit) return {coarse.middle, -1.0};
  // The span ends at corners, or where sides cross the extent's circle.
  double low = 1e9;
  double high = -1e9;
  const auto take = [&](Vec2 p) {
    const double slope = p.y / p.x;
    low = std::min(low, slope);
    high = std::max(high, slope);
  };
  for (int n = 0; n < 4; ++n) {
    const Vec2 p = corner[n];
    const Vec2 way = corner[(n + 1) % 4] - p;
    const double beyond = dot(p, p) - limit * limit;
    if (p.x < 1e-6) return coarse;  // it may contain the axis
    if (outside ? beyond <= 0.0 : beyond >= 0.0) take(p);
    const double square = dot(way, way);
    const double along = dot(p, way);
    const double root = along * along - square * beyond;
    if (root < 0.0) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-along + sign * std::sqrt(root)) / square;
      if (t >= 0.0 && t <= 1.0) take(p + t * way);
    }
  }
  if (low > high) return {coarse.middle, -1.0};
  const double from = portable::atan2(low, 1.0);
  const double to = portable::atan2(high, 1.0);
  const double base = portable::atan2(rz, rx);
  return overlap({base + 0.5 * (from + to), 0.5 * (to - from)}, coarse);
}

Turn overlap(const Turn& a, const Turn& b) noexcept {
  constexpr double kFull = 2.0 * portable::kPi;
  const double apart = a.middle - b.middle;
  const double near = apart - kFull * std::floor(apart / kFull + 0.5);
  const Turn& smaller = a.half < b.half ? a : b;
  if (a.half + b.half > kFull - std::fabs(near)) return smaller;
  const double low = std::max(near - a.half, -b.half);
  const double high = std::min(near + a.half, b.half);
  return {b.middle + 0.5 * (low + high), 0.5 * (high - low)};
}

void add_oval(Outline& outline, Vec3 through, Vec3 axis, double radius, double y) noexcept {
  if (std::fabs(axis.y) < kAskew) return;
  const Vec3 at = through + ((y - through.y) / axis.y) * axis;
  outline.oval = static_cast<float>(radius);
  outline.oval_x = static_cast<float>(at.x);
  outline.oval_z = static_cast<float>(at.z);
  outline.oval_ax = static_cast<float>(radius * axis.x / axis.y);
  outline.oval_az = static_cast<float>(radius * axis.z / axis.y);
}

}  // namespace onggi::body
