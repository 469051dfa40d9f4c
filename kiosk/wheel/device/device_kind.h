#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "kiosk/wheel/device/hid_port.h"

namespace onggi::device {

enum class DeviceKind : std::uint8_t { space_mouse, surface_dial, dual_sense, polhem, onggi_hid };

/// A kind's name and use, for staff and visitors.
struct KindInfo {
  DeviceKind kind;
  std::string_view id;    ///< "space_mouse", for files and reports.
  std::string_view name;  ///< "3Dconnexion SpaceMouse".
  std::string_view use;   ///< A sentence's end: "moves a hand".
  bool hand = false;      ///< It moves a hand,
  bool force = false;     ///< with force feedback,
  bool verified = true;   ///< False: its driver was never tested on real hardware.
};

std::span<const KindInfo> device_kinds();
const KindInfo& info_of(DeviceKind kind);

/// The kind whose driver may take the device; nothing for other devices. If a device lists several
/// interfaces or shares its numbers with others, its driver checks after opening.
std::optional<DeviceKind> kind_of(const HidListing& listing);

}  // namespace onggi::device
