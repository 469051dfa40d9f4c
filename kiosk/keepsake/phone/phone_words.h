#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::phone {

/// The page's words in one language: [text.phone] of content/languages/CODE.toml.
struct PhoneWords {
  std::string code, name;  ///< "ar", and the language's own name.
  bool right_to_left = false;
  std::map<std::string, std::string> texts;
  const std::string& operator[](const char* key) const { return texts.at(key); }
};

/// The languages of the page. English is compiled in and always there.
class PhoneLanguages {
 public:
  /// Only English.
  PhoneLanguages();
  /// Every language of `folder`, by code, English first. A language that cannot be read, or lacks a
  /// text, is left out and reported in `remarks`.
  static PhoneLanguages read(const std::filesystem::path& folder, std::vector<Problem>& remarks);

  const std::vector<PhoneWords>& all() const { return all_; }
  /// The language with this code; null if there is none.
  const PhoneWords* of(const std::string& code) const;
  /// The phone's favourite available language, from Accept-Language (RFC 9110, with weights); null
  /// if there is none.
  const PhoneWords* liked(const std::string& accept_language) const;

 private:
  std::vector<PhoneWords> all_;
};

}  // namespace onggi::phone
