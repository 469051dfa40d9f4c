#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// The wheel, the clay and the visitor's hand. `desk` outlives it.
std::unique_ptr<Screen> make_throwing(Desk& desk);

}  // namespace onggi::screens
