#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"

namespace onggi::rehearsal {

/// The screens that lead_to() knows, in the order of a visit: "attract", "label", "result".
std::span<const std::string_view> toured_screens();

/// The choices of the page Comfort, as exhibit.toml calls them.
std::vector<std::string> comfort_choices();
/// `screen` with these of comfort_choices() as well.
settings::Exhibit::Screen with_comfort(settings::Exhibit::Screen screen,
                                       const std::vector<std::string>& choices);

/// Leads a stepped kiosk, newly opened, to `screen`, one of toured_screens(), and stops there: with
/// the vessel `card` of the shelf, thrown by a script. Blocks for some seconds, the later the
/// screen the longer. Problem: exit 2 where this exhibit has no such screen for the vessel, 1 where
/// a control is missing. Main thread.
Result<void> lead_to(exhibit::Kiosk& kiosk, std::string_view screen, int card);

}  // namespace onggi::rehearsal
