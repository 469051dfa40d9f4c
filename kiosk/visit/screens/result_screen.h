#pragma once

#include <memory>

#include "kiosk/visit/screens/screen.h"

namespace onggi::screens {

/// Stars and words: what is alike, what to try. `desk` outlives it.
std::unique_ptr<Screen> make_result(Desk& desk);

}  // namespace onggi::screens
