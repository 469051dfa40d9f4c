#include "kiosk/collection/content/word_fields.h"

#include "kiosk/collection/content/language_words.h"
#include "kiosk/ground/toml/toml_places.h"
#include "kiosk/ground/toml/toml_splice.h"

namespace onggi::content {

const fields::FieldList& word_fields() {
  static const fields::FieldList kList = [] {
    fields::FieldList list{"languages/*.toml", {}};
    const toml::TomlPlaces places(kEnglishToml);
    for (const toml::TomlPlaces::Value& value : places.values()) {
      if (value.path.size() < 3 || value.path.front() != "text") continue;
      const toml::Path table(value.path.begin(), value.path.end() - 1),
          key(value.path.begin() + 1, value.path.end());
      const std::string* english = english_text(toml::key_text(key));
      if (english == nullptr) continue;
      list.fields.push_back(
          {.table = toml::key_text(table), .key = value.path.back(), .words = *english});
    }
    return list;
  }();
  return kList;
}

}  // namespace onggi::content
