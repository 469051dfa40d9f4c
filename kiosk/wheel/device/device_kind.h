#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "kiosk/wheel/device/hid_port.h"

namespace onggi::device {

/// The devices that have a driver.
enum class DeviceKind : std::uint8_t { space_mouse, surface_dial, dual_sense, polhem, onggi_hid };

/// What staff and visitors are told of a kind, and what it is good for.
struct KindInfo {
  DeviceKind kind;
  std::string_view id;    ///< "space_mouse": as in files and reports.
  std::string_view name;  ///< "3Dconnexion SpaceMouse".
  std::string_view use;   ///< A sentence's end: "moves a hand".
  bool hand = false;      ///< It moves a hand,
  bool force = false;     ///< and the hand feels force.
  bool verified = true;   ///< False: never tried on hardware by its driver's writers.
};

std::span<const KindInfo> device_kinds();
const KindInfo& info_of(DeviceKind kind);

/// Whose driver would take it; nothing for any other device. An id alone is not enough where a
/// device lists several interfaces, or shares its numbers with others: those are asked by their
/// driver once they are open.
std::optional<DeviceKind> kind_of(const HidListing& listing);

}  // namespace onggi::device
