#include "kiosk/device/stroke_plan.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr double kStep = 0.002;                 // m between the heights that are looked at
constexpr double kFoot = 0.006;                 // m over the floor where strokes begin
constexpr double kOut = 0.009;                  // m that a stroke widens at the most,
constexpr double kIn = 0.004;                   // and narrows
constexpr double kFirst = 0.003, kRamp = 0.35;  // m that a stroke begins with at the foot, m a m
constexpr double kBlend = 0.018;     // m of height over which a stroke sets in, to either side
constexpr double kQuick = 0.03;      // m/s along a wall that is far off,
constexpr double kSlow = 0.018;      // and along one that is nearly there
constexpr double kNearly = 0.003;    // m
constexpr double kSoftEdge = 0.006;  // m of height to either side over which that sets in
constexpr double kEvening = 0.0015;  // m that the last stroke moves a wall at the most
constexpr double kMargin = 0.0015;   // m of wall under the rim that no stroke goes over

// Two hands that hold a wall this thick do not bring it anywhere as one: it is opened first, down
// to what is left then.
constexpr double kThick = 0.016, kOpened = 0.008;  // m
constexpr double kRimLeft = 0.004;                 // m of a lip that no hand inside goes over
constexpr double kHandsRoom = 0.012;               // m over the floor, for the hand inside

struct Off {
  double height, now, off;  // of the target's face from the clay's
};

// Of the target where it answers `height` on the clay: clay that is kept gets lower as it widens
// and comes to the target's height with its shape.
double wanted(const ClayView& clay, const Profile& target, double height) {
  return target.outer_at(height * target.height() / std::max(clay.rim_height(), 0.01));
}

std::vector<Off> differences(const ClayView& clay, const Profile& target) {
  std::vector<Off> all;
  const double top = clay.rim_height() - kMargin;
  // A foot is solid: two hands only dig into it.
  for (double h = clay.floor_top() + kFoot; h <= top; h += kStep) {
    const double now = clay.radius_at(h, WallSide::outside);
    all.push_back({h, now, wanted(clay, target, h) - now});
  }
  return all;
}
// From the floor to the rim, a hand inside.
std::optional<Stroke> opening(const ClayView& clay, const Profile& target) {
  Stroke stroke;
  stroke.kind = Stroke::Kind::open;
  stroke.grip = Grip::inside;
  stroke.speed = kQuick;
  double most = 0;
  for (double h = clay.floor_top() + kHandsRoom; h <= clay.rim_height() - kRimLeft; h += kStep) {
    const double in = clay.radius_at(h, WallSide::inside);
    const double out = clay.radius_at(h, WallSide::outside);
    const double face = wanted(clay, target, h);
    // Where a wall opens as a whole, its ring keeps its clay, and the outer face goes along.
    const double along = std::sqrt(std::max(0.0, face * face - (out * out - in * in)));
    const double goal = std::min(std::min(out, face) - kOpened, along);
    const double deep = std::clamp(goal - in, 0.0, kOut);
    most = std::max(most, out - in > kThick ? deep : 0.0);
    stroke.path.push_back({in + deep, h});
  }
  return most > kNearly ? std::optional(stroke) : std::nullopt;
}
}  // namespace

std::optional<Stroke> next_stroke(const ClayView& clay, const Profile& target, double near_enough) {
  if (auto stroke = opening(clay, target)) return stroke;
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
  // Where one stroke cannot bring it all the way, what it does is drawn out over a hand's breadth:
  // the edge of a deep press would stand as a ledge until the next.
  for (std::size_t n = first; n <= last; ++n) {
    double deep = 0;
    const std::size_t from = n > reach ? n - reach : 0, to = std::min(all.size() - 1, n + reach);
    const auto step = [&all](const Off& at) {
      // Over the foot, which stays, a stroke sets in little by little.
      const double most_here = kFirst + kRamp * (at.height - all.front().height);
      return std::clamp(at.off, -std::min(kIn, most_here), std::min(kOut, most_here));
    };
    for (std::size_t m = from; m <= to; ++m)
      deep += step(all[m]) / static_cast<double>(to - from + 1);
    const double whole = step(all[n]);
    const double share = std::clamp(most / kNearly - 1.0, 0.0, 1.0);
    stroke.path.push_back({all[n].now + whole + share * (deep - whole), all[n].height});
  }
  return stroke;
}

Stroke last_stroke(const ClayView& clay, const Profile& target) {
  Stroke stroke;
  stroke.speed = kSlow;
  // Drawn out over a hand's breadth: where the wall is off by more on one side of a height, the
  // edge of what this stroke may do would stand as a ledge.
  const std::vector<Off> all = differences(clay, target);
  const auto reach = static_cast<std::size_t>(kSoftEdge / kStep);
  for (std::size_t n = 0; n < all.size(); ++n) {
    const std::size_t from = n > reach ? n - reach : 0, to = std::min(all.size() - 1, n + reach);
    double deep = 0;
    for (std::size_t m = from; m <= to; ++m)
      deep += std::clamp(all[m].off, -kEvening, kEvening) / static_cast<double>(to - from + 1);
    stroke.path.push_back({all[n].now + deep, all[n].height});
  }
  return stroke;
}

}  // namespace onggi::device
