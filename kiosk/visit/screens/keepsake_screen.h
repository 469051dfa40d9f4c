#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// The postcard, and the name under which it is kept. `desk` outlives it.
std::unique_ptr<Screen> make_keepsake(Desk& desk);

}  // namespace onggi::screens
