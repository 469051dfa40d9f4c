#include "engine/contact/bodies/cylinder.h"

#include <algorithm>
#include <cmath>

#include "engine/math/unit.h"

namespace onggi::body {
namespace {

Box box_round(Vec3 middle, Vec3 axis, double radius, double half) {
  const Vec3 level{axis.z, 0.0, -axis.x};
  const Vec3 first = length(level) > 1e-6 ? unit(level) : Vec3{1.0, 0.0, 0.0};
  Vec3 up = unit(cross(axis, first));
  if (up.y < 0.0) up = -up;
  return {middle, {first, up, axis}, {radius, radius, half}};
}

}  // namespace

Cylinder::Cylinder(Vec3 middle, Vec3 axis, double radius, double half) noexcept
    : box_(box_round(middle, axis, radius, half)) {}

// A point's height is the sum of two parts: its place up the face, and its place through the disc.
Approach Cylinder::approach() const noexcept {
  const Vec3 first = box_.axis[0], up = box_.axis[1];
  Approach of;
  if (up.y < kAskew) return of;
  of.level = box_.middle.y;
  of.at = {box_.middle.x, box_.middle.z};
  of.lean = {up.x / up.y, up.z / up.y};
  of.through = box_.half[2] * (Vec2{axis().x, axis().z} - axis().y * of.lean);
  of.across = {first.x, first.z};
  of.radius = radius();
  of.half = box_.half[2] * std::fabs(axis().y);
  of.rise = up.y;
  return of;
}

Outline Cylinder::outline(double y) const noexcept {
  // The lowest place up its face that the plane can cut. The level chord is longest there.
  const double rise = box_.axis[1].y;
  const double up = std::fabs(y - box_.middle.y) - box_.half[2] * std::fabs(axis().y);
  Box narrow = box_;
  if (rise > kAskew) {
    const double chord = cross_section(radius(), std::max(up / rise, 0.0));
    if (chord <= 0.0) {
      Outline none;
      none.round = -1.0f;
      return none;
    }
    narrow.half[0] = chord;
  }
  Outline out = narrow.outline(y);
  if (out.round >= 0.0f) add_oval(out, box_.middle, axis(), radius(), y);
  return out;
}

Ball Cylinder::support(Vec3 towards) const noexcept {
  const double through = dot(axis(), towards);
  const Vec3 flat = towards - through * axis();
  const double edge = length(flat);
  const double half = box_.half[2];
  const double farthest = dot(box_.middle, towards) + radius() * edge + half * std::fabs(through);
  Vec3 point = box_.middle + (half * support_end(axis(), towards)) * axis();
  if (edge > 1e-9) point += (radius() * std::min(edge / kSquareTo, 1.0) / edge) * flat;
  return support_ball(point, farthest, std::min(kBluntestEdge, radius()), towards);
}

Ball Cylinder::within(Vec3 towards) const noexcept {
  const double thick = box_.half[2];
  const double ball = std::min({kBluntestEdge, radius(), thick});
  const Vec3 flat = towards - dot(axis(), towards) * axis();
  const double edge = length(flat);
  Vec3 at = box_.middle + ((thick - ball) * support_end(axis(), towards)) * axis();
  if (edge > 1e-9) at += ((radius() - ball) * std::min(edge / kSquareTo, 1.0) / edge) * flat;
  return {at, ball};
}

Cylinder::Section Cylinder::section(double y) const noexcept {
  return {rod_section(box_.middle, axis(), radius(), y),
          slab_section(box_.middle, axis(), box_.half[2], y)};
}

}  // namespace onggi::body
