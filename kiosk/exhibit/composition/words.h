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

/// The exhibit's languages in its order, with `first` (a code) at the front unless empty.
/// Unreadable ones are logged; Problem if none is left or `first` is not among them.
Result<std::vector<content::Language>> read_languages(const settings::Exhibit& exhibit,
                                                      const std::string& first);

/// The language with `code`, else the first.
const content::Language& language_of(const std::vector<content::Language>& languages,
                                     const std::string& code);

/// The web address of the keepsake of `token`.
std::string phone_address(const settings::Exhibit& exhibit, const std::string& token);

/// The postcard's words in `language`, dated today.
souvenir::PostcardWords postcard_words(const content::Language& language,
                                       const content::Label& label,
                                       const settings::Exhibit& exhibit);

/// The loading screen of a large shelf: a sentence, and the progress.
view::Frame make_opening_frame(const content::Language& language, int width, int height, int done,
                               int total);

}  // namespace onggi::exhibit
