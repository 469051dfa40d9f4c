#include "kiosk/collection/settings/text_in.h"

namespace onggi::settings {

const std::string& text_in(const std::map<std::string, std::string>& words,
                           const std::string& language) {
  static const std::string kNoWords;
  for (const char* wanted : {language.c_str(), "en"})
    if (const auto found = words.find(wanted); found != words.end()) return found->second;
  return words.empty() ? kNoWords : words.begin()->second;
}

}  // namespace onggi::settings
