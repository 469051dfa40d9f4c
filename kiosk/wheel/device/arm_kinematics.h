#pragma once

#include <array>
#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// An arm of three cable-driven bodies on capstans, like WoodenHaptics and the first Polhem: a
/// turntable a, and on it two links b and c. Both links are driven from the base, so their angles
/// are measured from the upright. Defaults are the published values of WoodenHaptics 2015. The
/// linkage of Polhem 2 is different and not published, so it is not supported.
struct ArmDef {
  std::array<double, 3> capstan{0.010, 0.010, 0.010};  ///< Diameters, metres.
  std::array<double, 3> body{0.160, 0.120, 0.120};     ///< Diameters, metres.
  std::array<double, 3> length{0.080, 0.205, 0.245};   ///< Height of the first joint; b; c. Metres.
  std::array<double, 3> torque{0.0259, 0.0259, 0.0259};  ///< Torque constants of the motors, N m/A.
  std::array<int, 3> counts{2000, 2000, 2000};           ///< Encoder counts of one motor turn.
  /// The motor turns in the same direction as its body.
  std::array<bool, 3> aligned{false, false, false};
  /// Encoder counts of the parked arm, when it is switched on.
  std::array<int, 3> parked{0, 0, 6000};
  Vec3 origin{0.220, 0.0, 0.080};  ///< The point (0, 0, 0), metres.
  /// For each motor, 0..32767: continuous limit of its amplifier.
  double most_milliamperes = 2000.0;
  friend bool operator==(const ArmDef&, const ArmDef&) = default;
};

/// The arm's angles a, b, c, rad.
using ArmAngles = std::array<double, 3>;

ArmAngles arm_angles(const ArmDef& arm, const std::array<std::int16_t, 3>& counts) noexcept;
/// Position of the handle: x towards the visitor, y to the visitor's right, z up. Metres. Pure.
Vec3 arm_position(const ArmDef& arm, const ArmAngles& at) noexcept;
/// Motor currents, milliamperes, for `force` (N, the same frame): the Jacobian's transpose. Pure.
std::array<double, 3> arm_currents(const ArmDef& arm, const ArmAngles& at, Vec3 force) noexcept;

}  // namespace onggi::device
