#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// A pot that throws itself until a visitor comes. `desk` outlives it.
std::unique_ptr<Screen> make_attract(Desk& desk);

}  // namespace onggi::screens
