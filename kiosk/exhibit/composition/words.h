#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/keepsake/souvenir/postcard.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::exhibit {

/// The exhibit's languages in its order, `first` (a code) moved to the front unless empty. Those
/// that cannot be read are logged; a Problem when none is left or `first` is not among them.
Result<std::vector<content::Language>> read_languages(const settings::Exhibit& exhibit,
                                                      const std::string& first);

/// The language of `code`, else the first.
const content::Language& language_of(const std::vector<content::Language>& languages,
                                     const std::string& code);

/// Where a phone finds the keepsake of `token`.
std::string phone_address(const settings::Exhibit& exhibit, const std::string& token);

/// What the postcard says, in `language`, dated today.
souvenir::PostcardWords postcard_words(const content::Language& language,
                                       const content::Label& label, int stars,
                                       const settings::Exhibit& exhibit);

/// What stands on the screen while a large shelf is read: a sentence, and how far it is.
view::Frame make_opening_frame(const content::Language& language, int width, int height, int done,
                               int total);

}  // namespace onggi::exhibit
