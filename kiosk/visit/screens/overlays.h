#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The globe, Back, Help and Comfort, at the foot of every screen.
std::vector<Button> standing_buttons(const Desk& desk, bool with_back);
/// The controls that make an overlay legible: the globe and Comfort.
std::vector<Button> reading_buttons(const Desk& desk);
/// The globe, "language", which opens the page of languages; none if there is only one.
std::vector<Button> globe(const Desk& desk);

/// An overlay, which replaces the screen's words.
void lay_out_help(Page& page, const Desk& desk, const std::vector<std::string>& paragraphs,
                  const std::string& keys);
/// The question before a pot that is not kept is given up.
void lay_out_leaving(Page& page, const Desk& desk);
void lay_out_idle(Page& page, const Desk& desk, double seconds_left, double countdown);

}  // namespace onggi::screens
