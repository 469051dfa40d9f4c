#pragma once

#include <filesystem>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/wheel/device/device_file.h"
#include "kiosk/wheel/device/device_watch.h"

namespace onggi::exhibit {

/// Where the exhibit says how a kind of device is used: devices/KIND.toml beside its own file.
std::filesystem::path device_file(const settings::Exhibit& exhibit, device::DeviceKind kind);

/// What that file says, or the kind's usual where there is none.
device::DeviceRead device_of(const settings::Exhibit& exhibit, device::DeviceKind kind);

/// Reads all of them now, logs what is wrong, and answers from then on, on any thread.
device::DeviceWatch::Define defined_devices(const settings::Exhibit& exhibit);

}  // namespace onggi::exhibit
