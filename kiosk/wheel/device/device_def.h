#pragma once

#include <array>
#include <optional>

#include "engine/math/vec.h"
#include "kiosk/wheel/device/arm_kinematics.h"
#include "kiosk/wheel/device/device_kind.h"

namespace onggi::device {

/// One axis of the studio, as a device gives it.
struct DeviceAxis {
  int from = 0;       ///< Of the device's: 0 x, 1 y, 2 z.
  double sign = 1.0;  ///< 1 or -1.
  friend bool operator==(const DeviceAxis&, const DeviceAxis&) = default;
};

/// How much force a device gets whose stiffness nobody has measured, N: too little to hurt or to
/// howl, enough to be felt.
inline constexpr double kUnmeasuredCap = 1.0;

/// And how stiff its coupling is, N/m: what the least of the devices bears that `onggi lab loop`
/// looks at.
inline constexpr double kUnmeasuredStiffness = 19.0;

/// What a force device is, as far as its loop asks. As it stands, the least of them all.
struct DeviceBody {
  double mass = 0.045;     ///< Of the handle as it is felt, kg, 0.005..5.
  double damping = 0.1;    ///< Its own, N s/m, 0..20.
  double friction = 0.0;   ///< Its own, N, 0..5.
  double step = 0.000055;  ///< What its encoders tell apart at the handle, m, 0..0.001.
  int delay = 3;  ///< Ticks from where it is to the force that this makes, 0..8, the wire included.
  friend bool operator==(const DeviceBody&, const DeviceBody&) = default;
};

/// How one device is used: config/devices/*.toml, or default_def(). SI.
struct DeviceDef {
  std::array<DeviceAxis, 3> axes{{{0, 1.0}, {1, 1.0}, {2, 1.0}}};  ///< Studio x, y, z.
  Vec3 middle;                  ///< Of its workspace, metres, along the studio's axes.
  Vec3 home{0.12, 0.10, 0.04};  ///< Where in the studio that middle is, or where a puck begins.
  double scale = 1.0;           ///< Of a handle's way, 0.1..10.
  double speed = 0.16;          ///< m/s of a puck or stick pushed as far as it goes, 0.01..1.
  double dead = 0.06;           ///< Of its deflection, 0..0.5: what counts as none.
  double turn_speed = 2.0;      ///< rad/s of it twisted as far as it goes, 0..10.
  double smoothing = 0.008;     ///< s, 0..0.05: time constant between its reports.
  double lifts_after = 0.7;     ///< s without a deflection until the tool is lifted, 0.1..30.
  double max_force = 3.3;       ///< N, 0..22.2.
  double max_slew = 600.0;      ///< N/s, 10..1e5.
  double engage_time = 0.5;     ///< s, 0.05..5.
  double damping = 0.0;         ///< N s/m, 0..20: made in the device, where it `damps`.
  bool damps = false;           ///< A kind that can.
  /// N/m that its coupling may have, as `onggi lab loop --write` derived it from its body. None: no
  /// more than kUnmeasuredCap and kUnmeasuredStiffness.
  std::optional<double> stiffness_limit;
  DeviceBody body;
  ArmDef arm;  ///< Of Polhem and WoodenHaptics.
  friend bool operator==(const DeviceDef&, const DeviceDef&) = default;

  double cap() const {
    return stiffness_limit || max_force < kUnmeasuredCap ? max_force : kUnmeasuredCap;
  }
  /// What it takes by itself, N s/m.
  double own_damping() const { return body.damping + (damps ? damping : 0.0); }
  double coupling() const { return stiffness_limit.value_or(kUnmeasuredStiffness); }
};

/// Of a device without a file of its own.
DeviceDef default_def(DeviceKind kind);

/// `v` of the device along the studio's axes, and back.
Vec3 to_studio(const DeviceDef& def, Vec3 v) noexcept;
Vec3 to_device(const DeviceDef& def, Vec3 v) noexcept;

}  // namespace onggi::device
