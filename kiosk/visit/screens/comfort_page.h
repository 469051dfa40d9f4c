#pragma once

#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// What a visitor may have otherwise, each with a line of what it does and a switch: over any
/// screen. Low reach is left out where all of the screen is in reach, and the volume where there is
/// no sound.
void lay_out_comfort(Page& page, const Desk& desk);

/// Where the keyboard begins on it.
std::string first_comfort();

}  // namespace onggi::screens
