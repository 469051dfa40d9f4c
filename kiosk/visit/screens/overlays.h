#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// Back, Help, Comfort and the other languages, at the foot of every screen.
std::vector<Button> standing_buttons(const Desk& desk, bool with_back);
/// Those without which what lies over a screen may not be read: Comfort and the other languages.
std::vector<Button> reading_buttons(const Desk& desk);
/// "language" for the language after the present one, "language.CODE" for any others.
std::vector<Button> language_buttons(const Desk& desk);
/// The language that a control named by language_buttons() stands for.
std::optional<std::size_t> language_of(const Desk& desk, const std::string& control);

/// What lies over a screen instead of its words.
void lay_out_help(Page& page, const Desk& desk, const std::vector<std::string>& paragraphs,
                  const std::string& keys);
void lay_out_idle(Page& page, const Desk& desk, double seconds_left, double countdown);

}  // namespace onggi::screens
