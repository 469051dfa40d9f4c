#pragma once

#include <array>
#include <optional>

#include "engine/math/vec.h"
#include "kiosk/wheel/device/arm_kinematics.h"
#include "kiosk/wheel/device/device_kind.h"

namespace onggi::device {

/// One axis of the studio, taken from a device axis.
struct DeviceAxis {
  int from = 0;       ///< The device's axis: 0 x, 1 y, 2 z.
  double sign = 1.0;  ///< 1 or -1.
  friend bool operator==(const DeviceAxis&, const DeviceAxis&) = default;
};

/// Force limit of a device with unmeasured stiffness, N: too small to hurt or vibrate, large enough
/// to feel.
inline constexpr double kUnmeasuredCap = 1.0;

/// Coupling stiffness of such a device, N/m: the value for the weakest device that `onggi lab loop`
/// tests.
inline constexpr double kUnmeasuredStiffness = 19.0;

/// Mechanical properties for the stability analysis. Defaults describe the weakest supported
/// device.
struct DeviceBody {
  double mass = 0.045;     ///< Mass of the handle as felt, kg, 0.005..5.
  double damping = 0.1;    ///< Its own, N s/m, 0..20.
  double friction = 0.0;   ///< Its own, N, 0..5.
  double step = 0.000055;  ///< Resolution of its encoders at the handle, m, 0..0.001.
  int delay = 3;  ///< Ticks from a position to the force for it, 0..8, including the cable.
  friend bool operator==(const DeviceBody&, const DeviceBody&) = default;
};

/// How one device is used: config/devices/*.toml, or default_def(). SI units.
struct DeviceDef {
  std::array<DeviceAxis, 3> axes{{{0, 1.0}, {1, 1.0}, {2, 1.0}}};  ///< Studio x, y, z.
  Vec3 middle;  ///< Middle of its workspace, metres, along the studio's axes.
  /// Position of that middle in the studio, or the start position of a puck.
  Vec3 home{0.12, 0.10, 0.04};
  double scale = 1.0;        ///< Tool motion for handle motion, 0.1..10.
  double speed = 0.16;       ///< m/s at full deflection of a puck or stick, 0.01..1.
  double dead = 0.06;        ///< Share of the deflection that counts as none, 0..0.5.
  double turn_speed = 2.0;   ///< rad/s at full twist, 0..10.
  double smoothing = 0.008;  ///< s, 0..0.05: time constant between reports.
  double lifts_after = 0.7;  ///< s without deflection until the tool is lifted, 0.1..30.
  double max_force = 3.3;    ///< N, 0..22.2.
  double max_slew = 600.0;   ///< N/s, 10..1e5.
  double engage_time = 0.5;  ///< s, 0.05..5.
  double damping = 0.0;      ///< N s/m, 0..20: made by the device, if it `damps`.
  bool damps = false;        ///< True for kinds that can damp.
  /// Largest coupling stiffness, N/m, derived from its body by `onggi lab loop --write`. Absent:
  /// kUnmeasuredCap and kUnmeasuredStiffness apply.
  std::optional<double> stiffness_limit;
  DeviceBody body;
  ArmDef arm;  ///< For Polhem and WoodenHaptics.
  friend bool operator==(const DeviceDef&, const DeviceDef&) = default;

  double cap() const {
    return stiffness_limit || max_force < kUnmeasuredCap ? max_force : kUnmeasuredCap;
  }
  double own_damping() const { return body.damping + (damps ? damping : 0.0); }
  double coupling() const { return stiffness_limit.value_or(kUnmeasuredStiffness); }
};

/// For a device without a file of its own.
DeviceDef default_def(DeviceKind kind);

/// Converts `v` from the device's axes to the studio's, and back.
Vec3 to_studio(const DeviceDef& def, Vec3 v) noexcept;
Vec3 to_device(const DeviceDef& def, Vec3 v) noexcept;

}  // namespace onggi::device
