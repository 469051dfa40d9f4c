#pragma once

#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The Accessibility page over any screen: the visitor's choices, each with an explanation and a
/// switch. Leaves out low reach if the whole screen is in reach, and the volume if there is no
/// sound.
void lay_out_comfort(Page& page, const Desk& desk);

/// The control where the keyboard starts.
std::string first_comfort();

}  // namespace onggi::screens
