#include "kiosk/collection/settings/list_file.h"

#include <algorithm>

#include "engine/base/nearest_name.h"

namespace onggi::settings {

bool read_id(toml::TomlReader::Table& entry, std::string& id, const std::string& example,
             const std::string& other) {
  entry.require("id", "Write a short name of letters, digits and _: id = \"" + example + "\".");
  if (!entry.text("id", id)) return false;
  if (!id.empty() && id.size() <= 40 && std::ranges::all_of(id, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
      }))
    return true;
  entry.complain("id", "\"" + id + "\" is not a valid id.",
                 "Write 1 to 40 lower-case letters, digits and _: id = \"" +
                     (other.empty() ? example : other) + "\".");
  return false;
}

int read_one_of(toml::TomlReader::Table& entry, const std::string& key, const std::string& what,
                std::span<const std::string_view> names) {
  std::string text;
  if (!entry.text(key, text)) return -1;
  const auto found = std::ranges::find(names, text);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  const std::string nearest = nearest_name(text, names);
  entry.complain(key, "There is no " + what + " \"" + text + "\".",
                 (nearest.empty() ? "" : "Did you mean \"" + nearest + "\"? ") + "Choose one of " +
                     joined(names) + ".");
  return -1;
}

}  // namespace onggi::settings
