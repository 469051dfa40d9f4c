#pragma once

#include "kiosk/wheel/device/hid_port.h"

namespace onggi::device {

/// The devices of hidapi. No other file calls that library.
std::unique_ptr<HidBus> hidapi_bus();

}  // namespace onggi::device
