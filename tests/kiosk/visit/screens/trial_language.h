#pragma once

#include <string>

#include "kiosk/collection/content/language.h"

namespace onggi::screens {

// Languages that nobody speaks, made of the English one by a program: what a translation may do to
// a page is seen before there is one.

/// Longer by two fifths, as German and Finnish are than English, and each word too: "xl".
content::Language long_words();
/// In Hebrew letters, which a line sets from the right: "xr".
content::Language from_the_right();

/// `english` in one of them; {places} stay.
std::string in_long_words(const std::string& english);
std::string in_letters_from_the_right(const std::string& english);

}  // namespace onggi::screens
