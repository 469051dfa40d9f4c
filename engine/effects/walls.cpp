#include "engine/effects/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/portable.h"

namespace onggi {

namespace {

constexpr double kBeside = 0.008;  // m: about as far as a finger bends a wall sideways

// 0 below 0, 1 above 1, zero slope at both.
double smooth_step(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::span<const DefField<WallsDef>> WallsDef::fields() {
  static constexpr DefField<WallsDef> kFields[] = {
      {"support", &WallsDef::support, 0.001, 0.2, "m"},
      {"tear_thickness", &WallsDef::tear_thickness, 0.0, 0.02, "m"},
      {"tear_strain", &WallsDef::tear_strain, 0.0, 10.0, ""},
      {"bending_strength", &WallsDef::bending_strength, 0.0, 1e6, "Pa", "yield_stress"},
  };
  return kFields;
}

namespace effects {

double wall_support(const WallsDef& def, Vec3 pressing, Vec3 holding) noexcept {
  // Distance along the wall: up, and round it at the pressing hand's radius.
  const double radius = axis_distance(pressing);
  const double inward = axis_distance(holding);
  const double both = std::max(radius * inward, 1e-12);
  const double cosine = (pressing.x * holding.x + pressing.z * holding.z) / both;
  // The chord of the angle between them. It needs no arc cosine, and the far side counts as far.
  const double chord = radius * std::sqrt(std::max(2.0 - 2.0 * cosine, 0.0));
  const double up = pressing.y - holding.y;
  const double apart = std::sqrt(up * up + chord * chord) / def.support;
  return smooth_step(1.0 - apart);
}

double wall_bears(const WallsDef& def, double thickness, double strength) noexcept {
  return portable::kPi * strength * def.bending_strength * thickness * thickness;
}

double wall_push(double normal, double bears, double held) noexcept {
  const double alone = normal - held;
  if (!(bears > 0.0)) return held;
  const double over = alone / bears;
  return held + alone / std::sqrt(1.0 + over * over);
}

double clear_of_foot(const Clay& clay, double height) noexcept {
  return smooth_step((height - clay.floor_top()) / kBeside);
}

double wall_thickness(const Clay& clay, Vec3 at) noexcept {
  if (at.y <= clay.floor_top()) return std::numeric_limits<double>::infinity();
  // The rows whose middles lie just below and above that height. Solid rows have no wall.
  const int rows = clay.rows();
  const int above = std::clamp(clay.first_row_above(at.y), clay.floor_rows(), rows - 1);
  const int below = std::max(above - 1, clay.floor_rows());
  const double low = clay.row_height(below);
  const double high = clay.row_height(above);
  const double up = above > below ? std::clamp((at.y - low) / (high - low), 0.0, 1.0) : 0.0;

  const double turn = 2.0 * portable::kPi;
  const double element = turn / clay.sectors();
  const double radius = std::max(axis_distance(at), 1e-6);
  const double beside = std::min(kBeside / (radius * element), 0.5 * clay.sectors());
  double angle = portable::atan2(at.z, at.x);
  if (angle < 0.0) angle += turn;
  // In elements, counted from the first.
  const double from = angle / element - beside;
  const double to = angle / element + beside;
  double sum = 0.0;
  for (int k = static_cast<int>(std::floor(from)); k < to; ++k) {
    const double part = std::min(k + 1.0, to) - std::max(double(k), from);
    const auto i = static_cast<std::size_t>((k + 2 * clay.sectors()) % clay.sectors());
    const auto wall = [&](int j) { return double{clay.outer(j)[i]} - double{clay.inner(j)[i]}; };
    sum += part * ((1.0 - up) * wall(below) + up * wall(above));
  }
  return sum / (to - from);
}

}  // namespace effects
}  // namespace onggi
