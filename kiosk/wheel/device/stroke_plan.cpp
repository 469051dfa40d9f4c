#include "kiosk/wheel/device/stroke_plan.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr double kStep = 0.002;  // m between the sampled heights
constexpr double kFoot = 0.006;  // m over the floor where strokes begin
constexpr double kIn = 0.004;    // m that a stroke narrows at most
// M allowed at the foot, and how it grows with height (m a m)
constexpr double kFirst = 0.003, kRamp = 0.35;
constexpr double kBlend = 0.018;     // m of height, up and down, over which a stroke sets in
constexpr double kQuick = 0.03;      // m/s along a wall that is far from the target,
constexpr double kSlow = 0.018;      // and along one that is nearly at it
constexpr double kNearly = 0.003;    // m
constexpr double kSoftEdge = 0.006;  // m of height, up and down, over which it sets in
constexpr double kEvening = 0.0015;  // m that the last stroke moves a wall at most
constexpr double kMargin = 0.0015;   // m of wall under the rim that no stroke touches

// Two hands cannot move a wall this thick as one. It is opened first, until kOpened is left.
constexpr double kThick = 0.016, kOpened = 0.008;  // m
constexpr double kRimLeft = 0.004;                 // m of a lip that no inside hand reaches
constexpr double kHandsRoom = 0.012;               // m over the floor, for the hand inside

struct Off {
  double height, now, off;  // of the target's face from the clay's
};

std::vector<Off> differences(const ClayView& clay, const Profile& target) {
  std::vector<Off> all;
  const double top = clay.rim_height() - kMargin;
  // A foot is solid: two hands would only dig into it.
  for (double h = clay.floor_top() + kFoot; h <= top; h += kStep) {
    const double now = clay.radius_at(h, WallSide::outside);
    all.push_back({h, now, wanted_radius(clay, target, h) - now});
  }
  return all;
}
}  // namespace

double wanted_radius(const ClayView& clay, const Profile& target, double height) {
  return target.outer_at(height * target.height() / std::max(clay.rim_height(), 0.01));
}

std::optional<Stroke> opening_stroke(const ClayView& clay, const Profile& target, double widens) {
  Stroke stroke;
  stroke.kind = Stroke::Kind::open;
  stroke.grip = Grip::inside;
  stroke.speed = kQuick;
  double most = 0;
  for (double h = clay.floor_top() + kHandsRoom; h <= clay.rim_height() - kRimLeft; h += kStep) {
    const double in = clay.radius_at(h, WallSide::inside);
    const double out = clay.radius_at(h, WallSide::outside);
    const double face = wanted_radius(clay, target, h);
    // If the wall opens as a whole, its ring keeps its clay, so the outer face moves too.
    const double along = std::sqrt(std::max(0.0, face * face - (out * out - in * in)));
    const double goal = std::min(std::min(out, face) - kOpened, along);
    const double deep = std::clamp(goal - in, 0.0, widens);
    most = std::max(most, out - in > kThick ? deep : 0.0);
    stroke.path.push_back({in + deep, h});
  }
  return most > kNearly ? std::optional(stroke) : std::nullopt;
}

std::optional<Stroke> next_stroke(const ClayView& clay, const Profile& target, double near_enough,
                                  double widens) {
  if (auto stroke = opening_stroke(clay, target, widens)) return stroke;
  const std::vector<Off> all = differences(clay, target);
  std::size_t first = all.size(), last = 0;
  double most = 0, sum = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (std::abs(all[n].off) <= near_enough) continue;
    first = std::min(first, n);
    last = n;
    most = std::max(most, std::abs(all[n].off));
    sum += all[n].off;
  }
  if (first > last) return std::nullopt;
  const auto reach = static_cast<std::size_t>(kBlend / kStep);
  first = first > reach ? first - reach : 0;
  last = std::min(all.size() - 1, last + reach);
  Stroke stroke;
  stroke.kind = sum > 0 ? Stroke::Kind::belly : Stroke::Kind::collar;
  stroke.speed = most > kNearly ? kQuick : kSlow;
  // Use the same share at every height, so that a wall half-way to a shoulder is no steeper than
  // the shoulder. If each height moved as far as it may, the neck would arrive first and stand on a
  // step.
  double share = 1;
  for (std::size_t n = first; n <= last; ++n)
    share =
        std::min(share, (all[n].off > 0 ? widens : kIn) / std::max(std::abs(all[n].off), kNearly));
  for (std::size_t n = first; n <= last; ++n) {
    // Above the foot, which stays, a stroke sets in gradually.
    const double most_here = kFirst + kRamp * (all[n].height - all.front().height);
    stroke.path.push_back(
        {all[n].now + std::clamp(share * all[n].off, -most_here, most_here), all[n].height});
  }
  return stroke;
}

Profile rolled(const Profile& target, double radius) {
  constexpr double kFine = 0.001;
  Profile out = resampled(target, static_cast<int>(target.height() / kFine) + 2);
  const int count = static_cast<int>(out.points.size());
  const double step = target.height() / (count - 1);
  const int reach = static_cast<int>(radius / step);
  const auto bulge = [&](int n) {
    return std::sqrt(std::max(0.0, radius * radius - n * n * step * step));
  };
  const auto outer = [&](int n) { return out.points[static_cast<std::size_t>(n)].outer; };
  // Path of the middle, extended beyond foot and rim.
  std::vector<double> middle;
  for (int n = -reach; n < count + reach; ++n) {
    double far = 0;
    for (int m = std::max(0, n - reach); m <= std::min(count - 1, n + reach); ++m)
      far = std::max(far, outer(m) + bulge(m - n));
    middle.push_back(far);
  }
  for (int n = 0; n < count; ++n) {
    double face = middle[static_cast<std::size_t>(n + reach)] - radius;
    for (int m = n - reach; m <= n + reach; ++m)
      face = std::min(face, middle[static_cast<std::size_t>(m + reach)] - bulge(m - n));
    out.points[static_cast<std::size_t>(n)].outer = face;
  }
  return out;
}

Stroke last_stroke(const ClayView& clay, const Profile& target) {
  Stroke stroke;
  stroke.speed = kSlow;
  // Smooth over a hand's breadth. Where the wall is farther off on one side of a height, this
  // stroke's limit would leave a ledge.
  const std::vector<Off> all = differences(clay, target);
  const auto reach = static_cast<std::size_t>(kSoftEdge / kStep);
  for (std::size_t n = 0; n < all.size(); ++n) {
    const std::size_t from = n > reach ? n - reach : 0, to = std::min(all.size() - 1, n + reach);
    double deep = 0;
    for (std::size_t m = from; m <= to; ++m)
      deep += std::clamp(all[m].off, -kEvening, kEvening) / static_cast<double>(to - from + 1);
    // Like every stroke, it sets in above the foot.
    const double most_here = kRamp * (all[n].height - all.front().height);
    stroke.path.push_back({all[n].now + std::clamp(deep, -most_here, most_here), all[n].height});
  }
  return stroke;
}

}  // namespace onggi::device
