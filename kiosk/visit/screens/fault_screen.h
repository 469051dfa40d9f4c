#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// Kind words if the exhibit cannot continue. `desk` outlives it.
std::unique_ptr<Screen> make_fault(Desk& desk);

}  // namespace onggi::screens
