#pragma once

#include <map>
#include <string>

namespace onggi::settings {

/// The text in `language`, else in English, which most visitors read, else in the first language;
/// "" if there is none.
const std::string& text_in(const std::map<std::string, std::string>& words,
                           const std::string& language);

}  // namespace onggi::settings
