#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

/// What files with a list of [[name]] have in common: lessons, glazes, missions. Each function
/// notes Problems in its table. Allocates.

/// Reads the key `id`: 1 to 40 lower-case letters, digits and _. False if it is missing or invalid.
/// The remedies show `example`, and `other` where it was invalid ("": the same).
bool read_id(toml::TomlReader::Table& entry, std::string& id, const std::string& example,
             const std::string& other = {});

/// Index of the name that `key` holds; -1 if the key is missing or its name unknown. `what` says
/// what the names are: "kind of mission".
int read_one_of(toml::TomlReader::Table& entry, const std::string& key, const std::string& what,
                std::span<const std::string_view> names);

/// The same into an enum in the order of `names`; false leaves it alone.
template <class Choice>
bool read_one_of(toml::TomlReader::Table& entry, const std::string& key, const std::string& what,
                 std::span<const std::string_view> names, Choice& out) {
  const int found = read_one_of(entry, key, what, names);
  if (found >= 0) out = static_cast<Choice>(found);
  return found >= 0;
}

/// Every [[name]] of `reader`'s file for which read(table, entry) is true, in the file's order; not
/// a second one with the same id, nor more than `most` (`too_many` is that Problem's remedy).
template <class Entry, class Read>
std::vector<Entry> read_list(toml::TomlReader& reader, const std::string& name, std::size_t most,
                             const std::string& too_many, const Read& read) {
  std::vector<Entry> out;
  std::set<std::string> ids;
  auto root = reader.root();
  for (toml::TomlReader::Table& table : root.children(name)) {
    Entry entry;
    if (!read(table, entry)) continue;
    if (!ids.insert(entry.id).second)
      table.complain("id", "There are two " + name + "s \"" + entry.id + "\".",
                     "Give the second another id.");
    else if (out.size() == most)
      table.complain("", "There are more than " + std::to_string(most) + " " + name + "s.",
                     too_many);
    else
      out.push_back(std::move(entry));
  }
  root.finish();
  return out;
}

}  // namespace onggi::settings
