#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// The pot is decorated as the makers of the vessel did. Only where the vessel has a way. `desk`
/// outlives it.
std::unique_ptr<Screen> make_decorate(Desk& desk);

}  // namespace onggi::screens
