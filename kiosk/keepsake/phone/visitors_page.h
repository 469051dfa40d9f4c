#pragma once

#include <string>

#include "kiosk/keepsake/phone/phone_words.h"

namespace onggi::phone {

/// Pictures that not every keepsake has.
struct Pictures {
  bool turning = false, rollout = false, sheet = false;
};

/// The whole page of `token` in `words`. It offers every other language, first `own` (the phone's,
/// may be null), and the `pictures` that are there.
std::string visitors_page(const std::string& token, const PhoneWords& words, const PhoneWords* own,
                          const PhoneLanguages& languages, Pictures pictures);
/// A page of one sentence: `key` of [text.phone].
std::string sentence_page(const PhoneWords& words, const char* key);

}  // namespace onggi::phone
