#include "engine/profile/profile.h"

#include <algorithm>
#include <cmath>

namespace onggi {

namespace {

/// Linear between the points round `h`, `member` of them; clamped to the ends.
double radius_at(const std::vector<ProfilePoint>& points, double h, double ProfilePoint::*member) {
  if (points.empty()) return 0.0;
  const auto above =
      std::upper_bound(points.begin(), points.end(), h,
                       [](double height, const ProfilePoint& p) { return height < p.height; });
  if (above == points.begin()) return points.front().*member;
  if (above == points.end()) return points.back().*member;
  const ProfilePoint& a = *(above - 1);
  const ProfilePoint& b = *above;
  const double t = (h - a.height) / (b.height - a.height);
  return a.*member + t * (b.*member - a.*member);
}

std::string place(const std::string& name, std::size_t i) {
  return name + ", point " + std::to_string(i + 1);
}

}  // namespace

double Profile::max_radius() const {
  double widest = 0.0;
  for (const ProfilePoint& p : points) widest = std::max(widest, p.outer);
  return widest;
}

double Profile::outer_at(double h) const { return radius_at(points, h, &ProfilePoint::outer); }

double Profile::inner_at(double h) const { return radius_at(points, h, &ProfilePoint::inner); }

double Profile::floor_height() const {
  for (const ProfilePoint& p : points)
    if (p.inner > 0.0) return p.height;
  return height();
}

Profile scaled(const Profile& p, double factor) {
  Profile out = p;
  for (ProfilePoint& point : out.points) {
    point.height *= factor;
    point.outer *= factor;
    point.inner *= factor;
  }
  out.out_of_round *= factor;
  return out;
}

Profile resampled(const Profile& p, int n) {
  Profile out;
  out.inner_wall = p.inner_wall;
  out.out_of_round = p.out_of_round;
  out.points.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double h = p.height() * i / (n - 1);
    out.points.push_back({h, p.outer_at(h), p.inner_at(h)});
  }
  return out;
}

Result<void> validate(const Profile& p, const std::string& name) {
  if (p.points.size() < 2)
    return problem(name,
                   "the profile has " + std::to_string(p.points.size()) +
                       " points, but a wall needs at least two.",
                   "Give the radius at the foot and at the rim.");
  if (p.points.front().height != 0.0)
    return problem(place(name, 0), "the lowest point does not stand at height 0.",
                   "Measure heights from the surface the vessel stands on.");
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const ProfilePoint& a = p.points[i];
    if (!std::isfinite(a.height) || !std::isfinite(a.outer) || !std::isfinite(a.inner))
      return problem(place(name, i), "a height or radius is not a number.",
                     "Give finite heights and radii in metres.");
    if (i > 0 && a.height <= p.points[i - 1].height)
      return problem(place(name, i), "its height is not above the point before it.",
                     "Order the points from the foot to the rim, each higher than the last.");
    if (a.outer <= 0.0)
      return problem(place(name, i), "its outer radius is not above 0.",
                     "Give the distance from the axis to the outside of the wall.");
    if (a.inner < 0.0 || a.inner >= a.outer)
      return problem(place(name, i), "its inner radius is not between 0 and the outer radius.",
                     "Keep the inner radius below the outer one; 0 means solid.");
  }
  return {};
}

}  // namespace onggi
