#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

struct LanguageRead;

/// The words of one language, content/languages/<code>.toml: `code`, `name`, `right_to_left`,
/// `decimal`, and a flat table [text] of key = "text", where {name} marks a place to fill.
class Language {
 public:
  /// The language, or the first Problem of check_language().
  static Result<Language> read(const std::filesystem::path& file);
  const std::string& code() const { return code_; }
  const std::string& name() const { return name_; }  ///< In itself: "한국어".
  bool right_to_left() const { return right_to_left_; }
  /// What stands before tenths: "." as it comes, or ",".
  const std::string& decimal() const { return decimal_; }
  /// The text of `key` with {places} filled. A missing key gives "[key]" and is a test failure; a
  /// place that is not given stays as it is written.
  std::string say(const std::string& key,
                  const std::map<std::string, std::string>& places = {}) const;
  bool has(const std::string& key) const;
  /// The names of the places in the text of `key`, sorted, each once.
  std::vector<std::string> places(const std::string& key) const;
  std::vector<std::string> keys() const;

 private:
  friend LanguageRead check_language(const std::filesystem::path& file);
  std::string code_, name_, decimal_ = ".";
  bool right_to_left_ = false;
  std::map<std::string, std::string> texts_;
};

/// A language and everything found wrong in its file, with line and column.
struct LanguageRead {
  Language language;
  std::vector<Problem> problems;  ///< What keeps it from being spoken.
  std::vector<Problem> advice;    ///< Where it does not say what the program says in English.
  int keys_checked = 0;
};
LanguageRead check_language(const std::filesystem::path& file);

}  // namespace onggi::content
