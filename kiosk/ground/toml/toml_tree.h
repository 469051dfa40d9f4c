#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/base/result.h"

namespace onggi::toml {

/// A place in the file; lines and columns from 1.
struct Place {
  std::uint32_t line = 1, column = 1;
  auto operator<=>(const Place&) const = default;
};

/// A value of a TOML file and where it stands.
struct TomlNode {
  struct Member;
  using Table = std::vector<Member>;  ///< Sorted by key.
  using List = std::vector<TomlNode>;
  struct Date {};  ///< A date or a time; no setting uses one.
  std::variant<Date, bool, std::int64_t, double, std::string, List, Table> value;
  Place place;

  /// nullptr if it has another type.
  template <class T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
  /// True for [[name]]: a list of one or more tables and nothing else.
  bool is_list_of_tables() const;
};

struct TomlNode::Member {
  std::string key;
  Place place;  ///< Position of the key.
  TomlNode value;
};

/// The value of `key`, or nullptr.
const TomlNode* find(const TomlNode::Table& table, std::string_view key);

/// Parses `text`, the file `name`. Problem with line and column if it is not TOML.
Result<TomlNode::Table> parse_toml(const std::string& text, const std::string& name);

}  // namespace onggi::toml
