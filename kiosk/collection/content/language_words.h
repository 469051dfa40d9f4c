#pragma once

#include <string>
#include <vector>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

/// content/languages/en.toml as it was at build time: the keys and placeholders that the program
/// uses.
extern const char* const kEnglishToml;

/// The text of one key, and its place in the file.
struct WrittenText {
  std::string key;  ///< Full key: "attract.begin".
  std::string words;
  toml::TomlReader::Table table;  ///< The table that holds it,
  std::string name;               ///< and its name there.
};

/// The program's English for `key`; null if it has no such text. Reads the file once; any thread.
const std::string* english_text(const std::string& key);

/// The names of the {name} placeholders in `words`, sorted, without repeats.
std::vector<std::string> places_in(const std::string& words);

/// Notes in the reader of `text`, the table [text], each difference between `written` and the
/// program's texts: a missing key, with the English to translate; an unknown key, with the right
/// one if it is near or in another place; a placeholder that is missing or unknown.
void compare_with_english(toml::TomlReader::Table text, std::vector<WrittenText>& written);

/// Notes how many texts of a file that is not English are the English ones, if they are too many
/// for chance: somebody copied them and has not translated them yet.
void ask_for_translation(toml::TomlReader::Table text, const std::vector<WrittenText>& written);

}  // namespace onggi::content
