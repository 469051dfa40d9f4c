#include "engine/contact/tool_contact.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

double axis_distance(Vec3 p) { return std::sqrt(p.x * p.x + p.z * p.z); }

// Turned about the axis by the angle whose cosine and sine are given, from x towards z.
Vec3 turned(Vec3 p, double c, double s) { return {c * p.x - s * p.z, p.y, s * p.x + c * p.z}; }

Vec3 into_clay_frame(Vec3 p, double angle) {
  return turned(p, portable::cos(angle), -portable::sin(angle));
}

// The wall's faces at the tool's height (the top row above the rim) and angle. Clay frame.
struct WallThere {
  double outer, inner;
};

WallThere wall_at(const Clay& clay, Vec3 at) {
  const int row = std::clamp(clay.first_row_above(at.y), 0, clay.rows() - 1);
  const double turns = portable::atan2(at.z, at.x) / (2.0 * portable::kPi);
  const int sector = static_cast<int>(std::floor(turns * clay.sectors())) + clay.sectors();
  const auto i = static_cast<std::size_t>(sector % clay.sectors());
  return {double{clay.outer(row)[i]}, double{clay.inner(row)[i]}};
}

}  // namespace

int steps_for(const ToolSweep& sweep) noexcept {
  const Vec3 way = sweep.to - sweep.from;
  const double out = std::max(axis_distance(sweep.from), axis_distance(sweep.to));
  const double arc = std::fabs(sweep.angle_to - sweep.angle_from) * out;
  const double steps = std::ceil((2.0 * arc + length(way)) / (0.25 * sweep.radius));
  return static_cast<int>(std::clamp(steps, 1.0, double{kMostSteps}));
}

bool ToolContact::choose_side(const Clay& clay, Vec3 at, const ToolSweep& sweep) noexcept {
  const WallThere wall = wall_at(clay, at);
  const double d = axis_distance(at);
  const bool beside_wall = at.y < clay.rim_height() && (d > wall.outer || d < wall.inner);
  const bool by_position = beside_wall || sweep.wish == SideWish::by_position;
  const bool nearer = d < 0.5 * (wall.outer + wall.inner);
  const bool inside = by_position ? nearer : sweep.wish == SideWish::inside;
  side_ = inside ? WallSide::inside : WallSide::outside;

  const double here = depth_at(clay, side_, at, sweep.radius, &sum_.visited);
  if (beside_wall || here <= sweep.radius) return here > 0.0;
  // Over the rim or within the wall, and deep at first touch: the tool came along the other face.
  // Taking it for this one would cut the whole wall away.
  const double there = depth_at(clay, other(side_), at, sweep.radius, &sum_.visited);
  if (there < here) side_ = other(side_);
  return there > 0.0;
}

void ToolContact::step(Clay& clay, const ToolSweep& sweep, int n, int of,
                       const Yielding& yielding) noexcept {
  const double begin = static_cast<double>(n) / of;
  const double end = static_cast<double>(n + 1) / of;
  const Vec3 way = sweep.to - sweep.from;
  const double turn = sweep.angle_to - sweep.angle_from;
  const double angle = sweep.angle_from + end * turn;
  const double c = portable::cos(angle);
  const double s = portable::sin(angle);
  const SphereStep part{into_clay_frame(sweep.from + begin * way, sweep.angle_from + begin * turn),
                        turned(sweep.from + end * way, c, -s), sweep.radius, sweep.seconds / of};

  if (!touching_) {
    if (!choose_side(clay, part.to, sweep)) return;
  } else if (part.to.y > clay.rim_height()) {
    // Passed over the rim: beyond the wall's far face, not its middle, so that it cannot flutter.
    const WallThere wall = wall_at(clay, part.to);
    const double d = axis_distance(part.to);
    if (side_ == WallSide::outside && d < wall.inner)
      side_ = WallSide::inside;
    else if (side_ == WallSide::inside && d > wall.outer)
      side_ = WallSide::outside;
  }

  const Press press = onggi::press(clay, side_, part, yielding);
  touching_ = press.touched > 0;
  const double share = 1.0 / of;
  sum_.force += share * turned(press.force, c, s);
  sum_.normal += share * press.normal;
  sum_.depth = std::max(sum_.depth, press.depth);
  sum_.visited += press.visited;
  sum_.touched += press.touched;
}

}  // namespace onggi
