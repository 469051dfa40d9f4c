#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// Back, Help, Comfort and the other languages, at the foot of every screen.
std::vector<Button> standing_buttons(const Desk& desk, bool with_back);
/// The controls that make an overlay legible: Comfort and the other languages.
std::vector<Button> reading_buttons(const Desk& desk);
/// "language" for the language after the current one, "language.CODE" for others.
std::vector<Button> language_buttons(const Desk& desk);
std::optional<std::size_t> language_of(const Desk& desk, const std::string& control);

/// An overlay, which replaces the screen's words.
void lay_out_help(Page& page, const Desk& desk, const std::vector<std::string>& paragraphs,
                  const std::string& keys);
void lay_out_idle(Page& page, const Desk& desk, double seconds_left, double countdown);

}  // namespace onggi::screens
