#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

/// The words of one language, content/languages/<code>.toml: a flat table of key = "text", where
/// {name} marks a place to fill.
class Language {
 public:
  static Result<Language> read(const std::filesystem::path& file);
  const std::string& code() const { return code_; }
  const std::string& name() const { return name_; }  ///< In itself: "한국어".
  bool right_to_left() const { return right_to_left_; }
  /// The text of `key` with {places} filled. A missing key gives "[key]" and is a test failure.
  std::string say(const std::string& key,
                  const std::map<std::string, std::string>& places = {}) const;
  std::vector<std::string> keys() const;

 private:
  std::string code_, name_;
  bool right_to_left_ = false;
  std::map<std::string, std::string> texts_;
};

}  // namespace onggi::content
