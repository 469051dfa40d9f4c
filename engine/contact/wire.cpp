#include "engine/contact/wire.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kStrip = 0.002;   // m: width and depth of the strip that models the drag
constexpr double kSlow = 0.01;     // m/s: below this the drag fades, as friction does
constexpr double kAhead = 0.0003;  // m in front of the wire where its clay is looked for
constexpr double kWhole = 0.9999;  // a section cut this far is free
constexpr int kWireSamples = 256;  // places examined along the wire
constexpr float kUncut = 1e9f;

// Turns `p` into the clay's frame, which is turned by `angle`.
Vec3 in_clay(Vec3 p, double angle) {
  const double c = portable::cos(angle);
  const double s = portable::sin(angle);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

// Level, at a right angle to the wire, on the same side of the axis as `at`.
Vec3 across_wire(Vec3 along, Vec3 at) {
  const double level = axis_distance(along);
  if (level < 1e-6) return {};
  const Vec3 way{along.z / level, 0.0, -along.x / level};
  return dot(way, at) < 0.0 ? -way : way;
}

}  // namespace

WireCut::WireCut(int sectors)
    : from_outside_(static_cast<std::size_t>(sectors), kUncut),
      from_axis_(static_cast<std::size_t>(sectors), 0.0f) {}

void WireCut::forget() noexcept {
  if (!begun_) return;
  std::ranges::fill(from_outside_, kUncut);
  std::ranges::fill(from_axis_, 0.0f);
  begun_ = false;
  height_ = share_ = 0.0;
}

void WireCut::cut(const Clay& clay, int row, const WireSweep& sweep, Vec3 way) noexcept {
  const double before = dot(sweep.to, way);  // from the wire to the axis
  const Vec3 lengthwise{-way.z, 0.0, way.x};
  const double aside = dot(sweep.to, lengthwise);
  const Vec3 m = in_clay(way, sweep.angle);
  const Vec3 u = in_clay(lengthwise, sweep.angle);
  double whole = 0.0;
  double left = 0.0;
  for (std::size_t i = 0; i < from_outside_.size(); ++i) {
    const double c = double{clay.ray_cos()[i]};
    const double s = double{clay.ray_sin()[i]};
    const double facing = m.x * c + m.z * s;
    // The place where the wire crosses the ray. In front of the axis the wire came in from outside;
    // behind it, the wire goes outwards from the axis.
    const bool in_front = facing >= 0.0;
    double at = -1.0;
    if (in_front == (before > 0.0)) at = before / facing;
    if (in_front && before <= 0.0) at = 0.0;
    if (at >= 0.0 && std::fabs(at * (u.x * c + u.z * s) - aside) <= 0.5 * sweep.length) {
      const auto reach = static_cast<float>(at);
      if (in_front)
        from_outside_[i] = std::min(from_outside_[i], reach);
      else
        from_axis_[i] = std::max(from_axis_[i], reach);
    }
    const double inner = double{clay.inner(row)[i]};
    const double outer = double{clay.outer(row)[i]};
    whole += (outer - inner) * (outer + inner);
    const double low = std::max(inner, double{from_axis_[i]});
    const double high = std::min(outer, double{from_outside_[i]});
    if (high > low) left += (high - low) * (high + low);
  }
  const double share = whole > 0.0 ? 1.0 - left / whole : 0.0;
  share_ = std::max(share_, share > kWhole ? 1.0 : share);
}

// How many places along the wire, `step` apart, have clay in front of them.
int WireCut::samples_in_clay(const Clay& clay, int row, const WireSweep& sweep, Vec3 way,
                             double& step) const noexcept {
  const Vec3 lengthwise{-way.z, 0.0, way.x};
  const double ahead = dot(sweep.to, way) - kAhead;
  const double aside = dot(sweep.to, lengthwise);
  // Only the part of the wire that can be in clay.
  const double reach = std::min(0.5 * sweep.length, clay.def().radius_max + std::fabs(aside));
  step = 2.0 * reach / kWireSamples;
  const double per_radian = clay.sectors() / (2.0 * portable::kPi);
  int count = 0;
  for (int n = 0; n < kWireSamples; ++n) {
    const double on = aside - reach + (n + 0.5) * step;
    const Vec3 p = in_clay(ahead * way + on * lengthwise, sweep.angle);
    const double away = axis_distance(p);
    const int sector = static_cast<int>(std::floor(portable::atan2(p.z, p.x) * per_radian));
    const auto i = static_cast<std::size_t>((sector + clay.sectors()) % clay.sectors());
    const float low = std::max(clay.inner(row)[i], from_axis_[i]);
    const float high = std::min(clay.outer(row)[i], from_outside_[i]);
    count += away > double{low} && away < double{high} ? 1 : 0;
  }
  return count;
}

Press WireCut::draw(const Clay& clay, const WireSweep& sweep, WireHand& hand,
                    double stiffness) noexcept {
  const double height = begun_ ? height_ : std::max(sweep.to.y, 0.0);
  const int row = clay.first_row_above(height);
  if (row >= clay.rows() || free()) return {};
  if (!hand.drawing) {
    hand.way = across_wire(sweep.along, sweep.to);
    hand.drawing = dot(hand.way, sweep.to) > double{clay.outer_most(row)};
    return {};
  }
  double step = 0.0;
  Press press;
  press.visited = clay.sectors();
  press.touched = samples_in_clay(clay, row, sweep, hand.way, step);
  const double before = dot(sweep.to, hand.way);
  if (!begun_ && before < double{clay.outer_most(row)}) {
    begun_ = true;
    height_ = height;
  }
  if (begun_) cut(clay, row, sweep, hand.way);
  const double speed = dot(sweep.to - sweep.from, hand.way) / sweep.seconds;
  const double drag = stiffness * kStrip * kStrip * step * static_cast<double>(press.touched);
  press.force = (-drag * speed / std::sqrt(speed * speed + kSlow * kSlow)) * hand.way;
  return press;
}

void WireCut::add_to(StateHash& hash) const {
  if (!begun_) return;
  hash.add(height_);
  hash.add(share_);
  for (const float v : from_outside_) hash.add(double{v});
  for (const float v : from_axis_) hash.add(double{v});
}

}  // namespace onggi
