#include "engine/effects/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/portable.h"

namespace onggi {

namespace {

constexpr double kBeside = 0.008;  // m: about as far as a finger bends a wall

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
  // Apart along the wall: up, and round it where the pressing hand is.
  const double radius = axis_distance(pressing);
  const double inward = axis_distance(holding);
  const double both = std::max(radius * inward, 1e-12);
  const double cosine = (pressing.x * holding.x + pressing.z * holding.z) / both;
  // The chord of the angle between: no arc cosine, and the far side is far.
  const double chord = radius * std::sqrt(std::max(2.0 - 2.0 * cosine, 0.0));
  const double up = pressing.y - holding.y;
  const double apart = std::sqrt(up * up + chord * chord) / def.support;
  const double t = std::clamp(1.0 - apart, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double wall_bears(const WallsDef& def, double thickness, double strength) noexcept {
  return portable::kPi * strength * def.bending_strength * thickness * thickness;
}

double wall_push(double normal, double bears, double along) noexcept {
  if (!(bears > 0.0)) return 0.0;
  const double over = along * normal / bears;
  return 1.0 / std::sqrt(1.0 + over * over);
}

double wall_thickness(const Clay& clay, Vec3 at) noexcept {
  const int j = std::min(clay.first_row_above(at.y), clay.rows() - 1);
  if (j < clay.floor_rows()) return std::numeric_limits<double>::infinity();
  const double turn = 2.0 * portable::kPi;
  const double element = turn / clay.sectors();
  const double radius = std::max(axis_distance(at), 1e-6);
  const int beside = static_cast<int>(std::min(kBeside / (radius * element), 0.5 * clay.sectors()));
  double angle = portable::atan2(at.z, at.x);
  if (angle < 0.0) angle += turn;
  const int middle = static_cast<int>(angle / element);
  double sum = 0.0;
  for (int k = -beside; k <= beside; ++k) {
    const auto i = static_cast<std::size_t>((middle + k + 2 * clay.sectors()) % clay.sectors());
    sum += double{clay.outer(j)[i]} - double{clay.inner(j)[i]};
  }
  return sum / (2 * beside + 1);
}

}  // namespace effects
}  // namespace onggi
