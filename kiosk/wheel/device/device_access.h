#pragma once

#include <optional>

#include "engine/base/result.h"
#include "kiosk/wheel/device/device_kind.h"

namespace onggi::device {

/// What keeps this program from using the device at `listing`, with the exact remedy; nothing where
/// it may be read and written. Asks the system, opens nothing.
std::optional<Problem> access_problem(const HidListing& listing);

/// The line of config/udev/70-onggi-hid.rules that lets the group onggi use it.
std::string udev_rule(const HidListing& listing);

}  // namespace onggi::device
