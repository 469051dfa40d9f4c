#include "engine/contact/tool_balls.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kTurnsOver = 0.1;   // a straight part less askew than this is touched in between
constexpr double kBluntest = 0.008;  // m: no edge stands for a larger ball than a fingertip

// -1..1: which end of a part along `axis` is the farther one towards `towards`.
double end_of(Vec3 axis, Vec3 towards) {
  return std::clamp(dot(axis, towards) / kTurnsOver, -1.0, 1.0);
}

// A ball whose farthest point is as far as `farthest` (from the origin, along `towards`), beside
// `point`.
ToolBall ball_at(Vec3 point, double farthest, double radius, Vec3 towards) {
  return {point + (farthest - radius - dot(point, towards)) * towards, radius};
}

Vec3 unit(Vec3 v) { return (1.0 / length(v)) * v; }

}  // namespace

Block plate_block(const ToolPlace& place, const ToolSize& size) noexcept {
  return {place.at,
          {place.along, place.across, cross(place.along, place.across)},
          {0.5 * size.length, 0.5 * size.thickness, size.radius}};
}

Block disc_block(const ToolPlace& place, const ToolSize& size) noexcept {
  const Vec3 level{place.across.z, 0.0, -place.across.x};
  const Vec3 first = length(level) > 1e-6 ? unit(level) : Vec3{1.0, 0.0, 0.0};
  Vec3 up = unit(cross(place.across, first));
  if (up.y < 0.0) up = -up;
  return {place.at, {first, up, place.across}, {size.radius, size.radius, 0.5 * size.thickness}};
}

double ball_reach(const ToolSize& size) noexcept { return size.radius; }
double capsule_reach(const ToolSize& size) noexcept { return size.length + size.radius; }
double disc_reach(const ToolSize& size) noexcept {
  return length(Vec2{size.radius, 0.5 * size.thickness});
}
double radius_grain(const ToolSize& size) noexcept { return size.radius; }
double thickness_grain(const ToolSize& size) noexcept { return size.thickness; }

ToolBall own_ball(const ToolPlace& place, const ToolSize& size, Vec3) {
  return {place.at, size.radius};
}

ToolBall capsule_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards) {
  const double part = 0.5 + 0.5 * end_of(place.along, towards);
  const double farthest =
      dot(place.at, towards) + std::max(0.0, size.length * dot(place.along, towards)) + size.radius;
  return ball_at(place.at + (part * size.length) * place.along, farthest, size.radius, towards);
}

ToolBall plate_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards) {
  const Block block = plate_block(place, size);
  Vec3 point = block.middle;
  double farthest = dot(block.middle, towards);
  for (std::size_t k = 0; k < 3; ++k) {
    farthest += block.half[k] * std::fabs(dot(block.axis[k], towards));
    point += (block.half[k] * end_of(block.axis[k], towards)) * block.axis[k];
  }
  return ball_at(point, farthest, std::min(kBluntest, size.radius), towards);
}

ToolBall disc_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards) {
  const double through = dot(place.across, towards);
  const Vec3 flat = towards - through * place.across;
  const double edge = length(flat);
  const double half = 0.5 * size.thickness;
  const double farthest = dot(place.at, towards) + size.radius * edge + half * std::fabs(through);
  Vec3 point = place.at + (half * end_of(place.across, towards)) * place.across;
  if (edge > 1e-9) point += (size.radius * std::min(edge / kTurnsOver, 1.0) / edge) * flat;
  return ball_at(point, farthest, std::min(kBluntest, size.radius), towards);
}

ToolSize sized(const ToolShape& shape, const ToolSize& size) noexcept {
  return {size.radius > 0.0 ? size.radius : shape.usual.radius,
          size.length > 0.0 ? size.length : shape.usual.length,
          size.thickness > 0.0 ? size.thickness : shape.usual.thickness};
}

ToolPlace hold_tool(const ToolShape& shape, Vec3 at, Vec3 handle, double roll,
                    bool inside) noexcept {
  const double away = axis_distance(at);
  const Vec3 out = away > 1e-9 ? Vec3{at.x / away, 0.0, at.z / away} : Vec3{1.0, 0.0, 0.0};
  const Vec3 turn{-out.z, 0.0, out.x};
  const auto to_studio = [&](Vec3 v) {
    return (inside ? -v.x : v.x) * out + Vec3{0.0, v.y, 0.0} + v.z * turn;
  };
  const Vec3 usual_along = unit(to_studio(shape.hold.along));
  const Vec3 usual_across = to_studio(shape.hold.across);
  const double reach = length(handle);
  const Vec3 along = reach > 1e-9 ? (1.0 / reach) * handle : usual_along;
  // The usual way across, as near as the handle leaves it.
  Vec3 across = usual_across - dot(usual_across, along) * along;
  if (length(across) < 1e-3) across = usual_along - dot(usual_along, along) * along;
  across = unit(across);
  if (roll != 0.0)
    across = unit(portable::cos(roll) * across + portable::sin(roll) * cross(along, across));
  return {at, along, across};
}

}  // namespace onggi
