#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// All languages over any screen, each in its own name, in the exhibit's order and at the same
/// places whatever language is in use. A touch on one sets it and closes the page.
void lay_out_languages(Page& page, const Desk& desk);

/// The control of a language: "language.ko".
std::string language_control(const content::Language& language);
/// The index of the language with this control; nothing for other controls.
std::optional<std::size_t> language_of(const Desk& desk, const std::string& control);

}  // namespace onggi::screens
