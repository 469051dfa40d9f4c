#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/content/translation_tables.h"

namespace onggi::content {

struct LanguageRead;

/// The texts of one language, content/languages/<code>.toml: `code`, `name`, `right_to_left`,
/// `decimal`, and a flat table [text] of key = "text", where {name} is a placeholder. What it says
/// of vessels, glazes, steps and missions is read by read_translations().
class Language {
 public:
  /// The language, or the first Problem of check_language().
  static Result<Language> read(const std::filesystem::path& file);
  const std::string& code() const { return code_; }
  const std::string& name() const { return name_; }  ///< In the language itself: "한국어".
  bool right_to_left() const { return right_to_left_; }
  /// The decimal separator: "." or ",".
  const std::string& decimal() const { return decimal_; }
  /// The text of `key` with its placeholders filled; in English if this language lacks it. A key
  /// that the program does not know gives "[key]", which fails a test. A placeholder without a
  /// value stays as written.
  std::string say(const std::string& key,
                  const std::map<std::string, std::string>& places = {}) const;
  /// True if the language itself says `key`.
  bool has(const std::string& key) const;
  /// The names of the placeholders in the text of `key`, sorted, without repeats.
  std::vector<std::string> places(const std::string& key) const;
  std::vector<std::string> keys() const;

 private:
  friend LanguageRead check_language(const std::filesystem::path& file, const KnownIds& known);
  std::string code_, name_, decimal_ = ".";
  bool right_to_left_ = false;
  std::map<std::string, std::string> texts_;
};

/// A language, and everything wrong in its file, with line and column.
struct LanguageRead {
  Language language;
  std::vector<Problem> problems;  ///< Faults that make it unusable.
  std::vector<Problem> advice;    ///< Differences from the program's English.
  int keys_checked = 0;
};
/// `known`: the ids that the tables of other things may name ([glaze.celadon]).
LanguageRead check_language(const std::filesystem::path& file, const KnownIds& known = {});

}  // namespace onggi::content
