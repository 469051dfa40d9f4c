#pragma once

#include <map>
#include <string>

namespace onggi::settings {

/// What the languages' files say of the exhibit's own things, over what each thing's file says
/// itself: [glaze.celadon] name = "Seladon" in content/languages/de.toml. So a translator writes
/// one file. Plain values.
struct Translations {
  using Texts = std::map<std::string, std::string>;  ///< By key: "name".
  /// What one language says, by kind ("vessel", "glaze", "lesson", "mission") and id.
  using Language = std::map<std::string, std::map<std::string, Texts>>;
  std::map<std::string, Language> languages;  ///< By code.

  /// The text, or null.
  const std::string* find(const std::string& language, const std::string& kind,
                          const std::string& id, const std::string& key) const;
  /// Puts every language's text for `key` into `words`, in place of the thing's own. Allocates.
  void put(const std::string& kind, const std::string& id, const std::string& key,
           std::map<std::string, std::string>& words) const;
};

}  // namespace onggi::settings
