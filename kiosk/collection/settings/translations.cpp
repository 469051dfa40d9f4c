#include "kiosk/collection/settings/translations.h"

namespace onggi::settings {
namespace {

/// The value of `key`, or null.
template <class Map>
const auto* value_in(const Map* map, const std::string& key) {
  using Value = typename Map::mapped_type;
  if (map == nullptr) return static_cast<const Value*>(nullptr);
  const auto found = map->find(key);
  return found == map->end() ? nullptr : &found->second;
}

}  // namespace

const std::string* Translations::find(const std::string& language, const std::string& kind,
                                      const std::string& id, const std::string& key) const {
  return value_in(value_in(value_in(value_in(&languages, language), kind), id), key);
}

void Translations::put(const std::string& kind, const std::string& id, const std::string& key,
                       std::map<std::string, std::string>& words) const {
  for (const auto& [code, language] : languages)
    if (const std::string* const text = find(code, kind, id, key)) words[code] = *text;
}

}  // namespace onggi::settings
