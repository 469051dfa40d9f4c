#pragma once

#include "kiosk/wheel/device/hid_port.h"

namespace onggi::device {

/// hidapi's devices. Nothing else in the house calls that library.
std::unique_ptr<HidBus> hidapi_bus();

}  // namespace onggi::device
