#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// Attract's pot under the visitor's own hands, before any vessel is chosen: the finger that
/// touches it in attract presses it at once. `desk` outlives it.
std::unique_ptr<Screen> make_clay(Desk& desk);

}  // namespace onggi::screens
