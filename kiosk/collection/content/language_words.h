#pragma once

#include <string>
#include <vector>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

/// content/languages/en.toml, as the program was built with it: the keys that it says, and the
/// places that it fills in each.
extern const char* const kEnglishToml;

/// The text of one key, and where it is written.
struct WrittenText {
  std::string key;  ///< Whole: "attract.begin".
  std::string words;
  toml::TomlReader::Table table;  ///< That it stands in,
  std::string name;               ///< under this name.
};

/// The names of the places in `words`, {name} each, sorted, each once.
std::vector<std::string> places_in(const std::string& words);

/// Notes with the reader of `text`, the table [text], each way in which `written` is not what the
/// program says: a key that is missing, with the English to translate; one that it never says, with
/// the right one where that is near or stands elsewhere; a place that is missing or never filled.
void compare_with_english(toml::TomlReader::Table text, std::vector<WrittenText>& written);

}  // namespace onggi::content
