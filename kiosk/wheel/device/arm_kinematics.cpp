#include "kiosk/wheel/device/arm_kinematics.h"

#include <cmath>

#include "engine/math/portable.h"

namespace onggi::device {

namespace {

/// Signed turn of body `n` for one turn of its motor.
double ratio(const ArmDef& arm, std::size_t n) {
  return (arm.aligned[n] ? -1.0 : 1.0) * arm.capstan[n] / arm.body[n];
}

}  // namespace

ArmAngles arm_angles(const ArmDef& arm, const std::array<std::int16_t, 3>& counts) noexcept {
  ArmAngles at{};
  for (std::size_t n = 0; n < 3; ++n)
    at[n] = ratio(arm, n) * 2.0 * portable::kPi * counts[n] / arm.counts[n];
  return at;
}

Vec3 arm_position(const ArmDef& arm, const ArmAngles& at) noexcept {
  const double reach = arm.length[1] * std::sin(at[1]) + arm.length[2] * std::sin(at[2]);
  return Vec3{std::cos(at[0]) * reach, std::sin(at[0]) * reach,
              arm.length[0] + arm.length[1] * std::cos(at[1]) - arm.length[2] * std::cos(at[2])} -
         arm.origin;
}

std::array<double, 3> arm_currents(const ArmDef& arm, const ArmAngles& at, Vec3 force) noexcept {
  const double ca = std::cos(at[0]), sa = std::sin(at[0]);
  const double reach = arm.length[1] * std::sin(at[1]) + arm.length[2] * std::sin(at[2]);
  // Columns of the Jacobian: the handle's motion for each angle.
  const Vec3 a{-sa * reach, ca * reach, 0.0};
  const double b_out = arm.length[1] * std::cos(at[1]), c_out = arm.length[2] * std::cos(at[2]);
  const Vec3 b{ca * b_out, sa * b_out, -arm.length[1] * std::sin(at[1])};
  const Vec3 c{ca * c_out, sa * c_out, arm.length[2] * std::sin(at[2])};
  const std::array<double, 3> torque{dot(a, force), dot(b, force), dot(c, force)};
  std::array<double, 3> currents{};
  for (std::size_t n = 0; n < 3; ++n) currents[n] = 1e3 * torque[n] * ratio(arm, n) / arm.torque[n];
  return currents;
}

}  // namespace onggi::device
