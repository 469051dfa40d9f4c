#pragma once

#include <filesystem>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/wheel/device/device_file.h"
#include "kiosk/wheel/device/device_watch.h"

namespace onggi::exhibit {

/// The exhibit's file for a kind of device: devices/KIND.toml beside exhibit.toml.
std::filesystem::path device_file(const settings::Exhibit& exhibit, device::DeviceKind kind);

/// The settings in that file, or the kind's defaults if there is none.
device::DeviceRead device_of(const settings::Exhibit& exhibit, device::DeviceKind kind);

/// Reads all of them now, logs Problems, and returns a lookup for any thread.
device::DeviceWatch::Define defined_devices(const settings::Exhibit& exhibit);

}  // namespace onggi::exhibit
