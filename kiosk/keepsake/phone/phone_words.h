#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::phone {

/// What the page says in one language: [text.phone] of content/languages/CODE.toml.
struct PhoneWords {
  std::string code, name;  ///< "ar", and its name in itself.
  bool right_to_left = false;
  std::map<std::string, std::string> texts;
  const std::string& operator[](const char* key) const { return texts.at(key); }
};

/// The languages that the page speaks. English is the program's own and always there.
class PhoneLanguages {
 public:
  /// English alone.
  PhoneLanguages();
  /// Every language of `folder`, by code, English first. What cannot be read, or lacks a text, is
  /// left out and said in `remarks`.
  static PhoneLanguages read(const std::filesystem::path& folder, std::vector<Problem>& remarks);

  const std::vector<PhoneWords>& all() const { return all_; }
  /// Of this code; null where it is not spoken.
  const PhoneWords* of(const std::string& code) const;
  /// The language that a phone likes best, by its Accept-Language (RFC 9110, weights and all);
  /// null where none of it is spoken.
  const PhoneWords* liked(const std::string& accept_language) const;

 private:
  std::vector<PhoneWords> all_;
};

}  // namespace onggi::phone
