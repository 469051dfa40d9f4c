#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/wheel/device/device_def.h"

namespace onggi::device {

struct DeviceRead {
  device::DeviceDef def;
  std::vector<Problem> problems;  ///< With file, line and column.
  int keys_checked = 0;
};

/// Reads how a device kind is used: config/devices/KIND.toml. On problems `def` holds every valid
/// value, and those of `usual` elsewhere. config/README.md lists the keys.
DeviceRead read_device(const std::filesystem::path& file, const device::DeviceDef& usual);

}  // namespace onggi::device
