#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// The postcard, and where it is kept. `desk` outlives it.
std::unique_ptr<Screen> make_keepsake(Desk& desk);

}  // namespace onggi::screens
