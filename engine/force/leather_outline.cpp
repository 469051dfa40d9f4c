#include "engine/force/leather_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::force {

namespace {
constexpr double kSame = 1e-6;  // m: closer corners are one
constexpr double kOnIt = 1e-9;  // m: nearer, the way to the wall has no direction
}  // namespace

LeatherOutline::LeatherOutline(const std::vector<Vec2>& corners, double begins, double apart) {
  corners_.reserve(corners.size());
  double told = begins - apart;
  for (const Vec2& at : corners) {
    told += apart;
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) continue;
    double along = told;
    if (!corners_.empty()) {
      const Corner& last = corners_.back();
      const double way = length(at - last.at);
      if (way < kSame) continue;
      if (!(apart > 0.0)) along = last.along + way;
    }
    corners_.push_back({at, along});
  }
}

NearWall LeatherOutline::near(Vec3 at) const noexcept {
  return near(at, 0.0, std::numeric_limits<double>::infinity());
}

NearWall LeatherOutline::near(Vec3 at, double along, double reach) const noexcept {
  NearWall found;
  found.depth = -std::numeric_limits<double>::max();
  const double radius = axis_distance(at);
  double least = std::numeric_limits<double>::infinity();
  Vec2 way{1.0, 0.0};   // from the wall to the place,
  Vec2 face{1.0, 0.0};  // and out of the clay there
  double beyond = 0.0;  // along that stretch, past its ends
  for (std::size_t n = 0; n + 1 < corners_.size(); ++n) {
    const Corner &a = corners_[n], &b = corners_[n + 1];
    if (b.along < along - reach || a.along > along + reach) continue;
    const double long_is = length(b.at - a.at);
    const Vec2 to{(b.at.x - a.at.x) / long_is, (b.at.y - a.at.y) / long_is};
    const Vec2 from_a{radius - a.at.x, at.y - a.at.y};
    const double asked = from_a.x * to.x + from_a.y * to.y;
    const double gone = std::clamp(asked, 0.0, long_is);
    const Vec2 off{from_a.x - gone * to.x, from_a.y - gone * to.y};
    const double square = off.x * off.x + off.y * off.y;
    // At a corner the two stretches are equally near: that one tells the side which the place is
    // less far past.
    const double past = std::fabs(asked - gone);
    if (square > least + kOnIt * kOnIt || (square > least - kOnIt * kOnIt && past >= beyond))
      continue;
    least = square;
    beyond = past;
    way = off;
    face = {to.y, -to.x};
    found.along = a.along + gone / long_is * (b.along - a.along);
  }
  if (!std::isfinite(least)) return found;
  const double far = std::sqrt(least);
  const bool outside = way.x * face.x + way.y * face.y >= 0.0;
  found.depth = outside ? -far : far;
  const double sign = outside ? 1.0 : -1.0;
  const Vec2 out = far > kOnIt ? Vec2{sign * way.x / far, sign * way.y / far} : face;
  // On the axis every direction is as good.
  const double c = radius > kOnIt ? at.x / radius : 1.0, s = radius > kOnIt ? at.z / radius : 0.0;
  found.out = {out.x * c, out.y, out.x * s};
  return found;
}

}  // namespace onggi::force
