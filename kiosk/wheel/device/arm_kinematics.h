#pragma once

#include <array>
#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// An arm of three cable-driven bodies on capstans, as WoodenHaptics and the first Polhem have it:
/// a turntable a, and on it two links b and c, each driven from the base, so that an angle is the
/// link's own against the upright. Defaults are WoodenHaptics 2015 as its makers publish it. The
/// linkage of Polhem 2 is not published: its arm is another, and is not driven.
struct ArmDef {
  std::array<double, 3> capstan{0.010, 0.010, 0.010};  ///< Diameters, metres.
  std::array<double, 3> body{0.160, 0.120, 0.120};     ///< Diameters, metres.
  std::array<double, 3> length{0.080, 0.205, 0.245};   ///< Height of the first joint; b; c. Metres.
  std::array<double, 3> torque{0.0259, 0.0259, 0.0259};  ///< N m a ampere, of the motors.
  std::array<int, 3> counts{2000, 2000, 2000};           ///< Of a motor's turn.
  std::array<bool, 3> aligned{false, false, false};      ///< The motor turns as its body does.
  std::array<int, 3> parked{0, 0, 6000};  ///< Counts where the arm is when it is switched on.
  Vec3 origin{0.220, 0.0, 0.080};         ///< What is (0, 0, 0), metres.
  double most_milliamperes = 2000.0;      ///< A motor, 0..32767: what its amplifier bears for long.
  friend bool operator==(const ArmDef&, const ArmDef&) = default;
};

/// The arm's angles a, b, c, rad.
using ArmAngles = std::array<double, 3>;

ArmAngles arm_angles(const ArmDef& arm, const std::array<std::int16_t, 3>& counts) noexcept;
/// Where the handle is: x towards the visitor, y to the visitor's right, z up. Metres. Pure.
Vec3 arm_position(const ArmDef& arm, const ArmAngles& at) noexcept;
/// What currents, milliamperes, make `force` (N, the same frame): the Jacobian's transpose. Pure.
std::array<double, 3> arm_currents(const ArmDef& arm, const ArmAngles& at, Vec3 force) noexcept;

}  // namespace onggi::device
