#include "kiosk/collection/settings/text_by_language.h"

#include <utility>

namespace onggi::settings {

std::map<std::string, std::string> read_by_language(toml::TomlReader::Table& entry,
                                                    const std::string& key, TextBound bound,
                                                    const std::vector<std::string>& languages) {
  std::map<std::string, std::string> out;
  toml::TomlReader::Table words = entry.child(key);
  for (const std::string& code : words.keys()) {
    std::string text;
    if (read_visitor_text(words, code, key + "." + code, bound, text)) out[code] = std::move(text);
  }
  for (const std::string& code : languages)
    if (!words.has(code))
      entry.complain(
          words.present() ? key : "", "There is no " + key + " in the language \"" + code + "\".",
          "Write " + key + " = { " + code + " = \"...\" }, one entry for each language.");
  if (languages.empty() && !words.has("en"))
    entry.complain(words.present() ? key : "", "There is no " + key + " in English.",
                   "Write " + key +
                       " = { en = \"...\" }, one entry for each language. English is shown where a "
                       "language lacks it.");
  words.finish();
  return out;
}

}  // namespace onggi::settings
