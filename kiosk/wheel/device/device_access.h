#pragma once

#include <optional>

#include "engine/base/result.h"
#include "kiosk/wheel/device/device_kind.h"

namespace onggi::device {

/// Why this program cannot use the device at `listing`, with the exact remedy; nothing if it can
/// read and write it. Asks the system and opens nothing.
std::optional<Problem> access_problem(const HidListing& listing);

/// The line of config/udev/70-onggi-hid.rules that gives the group onggi access to it.
std::string udev_rule(const HidListing& listing);

}  // namespace onggi::device
