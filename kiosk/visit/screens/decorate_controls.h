#pragma once

#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The mark on the pot, which keys and buttons move: Enter on it does the tool's work there.
inline constexpr const char* kMark = "decorate.mark";

/// Words and controls beside the pot that is decorated. `shows`: an example draws itself. `soon`:
/// the visitor has had a good while. Controls: "decorate.tool.N", "decorate.color.N",
/// "decorate.figure.N", "decorate.times.N" (N: repeats), "decorate.more" where tools stand behind
/// it, "decorate.show", "decorate.undo", "decorate.on", and for who uses buttons "decorate.higher",
/// "decorate.lower", "decorate.here".
void lay_out_decorating(Page& page, const Desk& desk, const decorating::DecoratedPot& pot,
                        bool shows, bool soon);

/// The choice or the step that `control` names; false if it is none of the pot's.
bool press_decorating(const std::string& control, decorating::DecoratedPot& pot);

/// What was done in the visitor's language: "cut, flooded with white slip"; "" of a bare
/// pot.
std::string did_in_words(const Desk& desk, const decorating::DecoratedPot& pot);

}  // namespace onggi::screens
