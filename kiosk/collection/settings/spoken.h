#pragma once

#include <map>
#include <string>

namespace onggi::settings {

/// Of a curator's words by language: those of `language`, else the English ones, which most
/// visitors read, else the first there are; "" where there are none.
const std::string& spoken(const std::map<std::string, std::string>& words,
                          const std::string& language);

}  // namespace onggi::settings
