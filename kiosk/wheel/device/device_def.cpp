#include "kiosk/wheel/device/device_def.h"

namespace onggi::device {

namespace {
/// The handle then reaches from beyond the axis to the widest wall, and from the wheel to the rim.
constexpr Vec3 kHandleHome{0.06, 0.10, 0.02};
}  // namespace

DeviceDef default_def(DeviceKind kind) {
  DeviceDef def;
  switch (kind) {
    case DeviceKind::polhem:
      // x towards the visitor, y to the right, z up. A thousand positions a second need no
      // smoothing.
      def.axes = {{{1, 1.0}, {2, 1.0}, {0, 1.0}}};
      def.smoothing = 0.0;
      def.home = kHandleHome;
      break;
    case DeviceKind::onggi_hid:
      def.damps = true;
      def.smoothing = 0.0;
      def.home = kHandleHome;
      break;
    case DeviceKind::dual_sense:
      def.speed = 0.10;
      def.dead = 0.12;  // Sticks do not return exactly to the middle.
      break;
    case DeviceKind::space_mouse:
    case DeviceKind::surface_dial:
      break;
  }
  return def;
}

Vec3 to_studio(const DeviceDef& def, Vec3 v) noexcept {
  const std::array<double, 3> from{v.x, v.y, v.z};
  const auto along = [&](const DeviceAxis& axis) {
    return axis.sign * from[static_cast<std::size_t>(axis.from)];
  };
  return {along(def.axes[0]), along(def.axes[1]), along(def.axes[2])};
}

Vec3 to_device(const DeviceDef& def, Vec3 v) noexcept {
  const std::array<double, 3> from{v.x, v.y, v.z};
  std::array<double, 3> to{};
  for (std::size_t n = 0; n < 3; ++n)
    to[static_cast<std::size_t>(def.axes[n].from)] += def.axes[n].sign * from[n];
  return {to[0], to[1], to[2]};
}

}  // namespace onggi::device
