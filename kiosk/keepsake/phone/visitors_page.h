#pragma once

#include <string>

#include "kiosk/keepsake/phone/phone_words.h"

namespace onggi::phone {

/// The whole page of `token` in `words`. It offers every other language, first `own` (the phone's,
/// may be null), and the turning picture if there is one.
std::string visitors_page(const std::string& token, const PhoneWords& words, const PhoneWords* own,
                          const PhoneLanguages& languages, bool turning);
/// A page of one sentence: `key` of [text.phone].
std::string sentence_page(const PhoneWords& words, const char* key);

}  // namespace onggi::phone
