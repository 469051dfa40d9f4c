#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// The pot dries and gets its glaze. Only if the scene has a kiln. `desk` outlives it.
std::unique_ptr<Screen> make_kiln(Desk& desk);

}  // namespace onggi::screens
