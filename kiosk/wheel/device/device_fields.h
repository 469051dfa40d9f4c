#pragma once

#include "kiosk/ground/fields/field.h"

namespace onggi::device {

/// Every key of config/devices/KIND.toml. read_device() goes by it.
const fields::FieldList& device_fields();

}  // namespace onggi::device
