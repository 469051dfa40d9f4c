#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// The shelf, and the label of a vessel. `desk` outlives it.
std::unique_ptr<Screen> make_choose(Desk& desk);

}  // namespace onggi::screens
