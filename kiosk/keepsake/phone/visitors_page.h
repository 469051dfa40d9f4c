#pragma once

#include <string>

#include "kiosk/keepsake/phone/phone_words.h"

namespace onggi::phone {

/// The page of `token`, whole, in `words`. It offers every other language, `own` (the phone's, may
/// be null) first and on top; and the picture that turns, where there is one.
std::string visitors_page(const std::string& token, const PhoneWords& words, const PhoneWords* own,
                          const PhoneLanguages& languages, bool turning);
/// A page of one sentence: `key` of [text.phone].
std::string sentence_page(const PhoneWords& words, const char* key);

}  // namespace onggi::phone
