#pragma once

// Inside of TomlReader, for its own sources only.

#include <cstdint>  // toml++ uses its names without including it

// Compiled in here, whatever the package offers: its library asserts and throws where we want a
// Problem. Without NDEBUG an assertion of toml++ is TOML_ASSERT and nothing else: with NDEBUG it
// becomes a promise to the compiler, and a typing error such as "[.]" breaks it (toml++ 3.3 and 3.4
// assert that a [header] begins with a letter just before the loop that reports what does not).
// Its other fault, letters that it takes for spaces, is kept away by AsciiToml.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_MAX_NESTED_VALUES 64
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>
#include <map>
#include <optional>

#include "kiosk/ground/toml/ascii_toml.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml {

/// The value if `node` is a T; else null.
template <class T>
const T* as(const ::toml::node& node) {
  const auto* value = node.as<T>();
  return value == nullptr ? nullptr : &value->get();
}

struct TomlReader::Impl {
  std::string name;               // as it was given, for every Problem
  std::optional<AsciiToml> text;  // tells the places in the file
  ::toml::table root;
  bool ok = false;
  std::vector<Problem> problems;
  std::vector<Place> places;  // of each Problem: both are kept in file order
  std::map<std::string, std::shared_ptr<Table::Impl>> tables;  // by path
  int keys_checked = 0;

  std::string where(Place at) const {
    return name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
  }
  Place place(const ::toml::source_region& source) const {
    return text->original({std::max(1u, source.begin.line), std::max(1u, source.begin.column)});
  }
  void note(Place at, std::string what, std::string remedy) {
    if (!ok) return;  // the parser has already reported the error
    const auto after = std::upper_bound(places.begin(), places.end(), at);
    problems.insert(problems.begin() + (after - places.begin()),
                    Problem{where(at), std::move(what), std::move(remedy)});
    places.insert(after, at);
  }
  Table table(const std::string& path, const ::toml::table* node, Place at);
};

struct TomlReader::Table::Impl {
  TomlReader::Impl* file = nullptr;
  const ::toml::table* node = nullptr;  // null: absent
  std::string path;                     // "" is the root
  Place place;
  std::vector<std::string> asked;
  bool finished = false;

  std::string full(std::string_view key) const {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
  }
  /// The value of `key`, or null. Records that it was asked for.
  const ::toml::node* ask(std::string_view key) {
    const ::toml::node* value = node == nullptr ? nullptr : node->get(key);
    if (std::find(asked.begin(), asked.end(), key) == asked.end()) {
      asked.emplace_back(key);
      if (value != nullptr && !value->is_table() && !value->is_array_of_tables()) {
        ++file->keys_checked;
      }
    }
    return value;
  }
  Place place_of_key(std::string_view key) const {
    const ::toml::node* value = key.empty() || node == nullptr ? nullptr : node->get(key);
    return value == nullptr ? place : file->place(value->source());
  }
  void wrong_type(std::string_view key, const ::toml::node& value, const std::string& wanted,
                  std::string remedy);
  void out_of_range(std::string_view key, const ::toml::node& value, double low, double high,
                    std::string_view unit, const std::string& remedy);
  /// The list at `key`; notes a Problem if the value is not a list.
  const ::toml::array* ask_list(std::string_view key, const std::string& wanted,
                                const std::string& remedy);
  /// What to write instead of the key `wrong`, as a sentence.
  std::string right_name(const std::string& wrong) const;
  std::string element(std::string_view key, std::size_t index) const {
    return std::string(key) + "[" + std::to_string(index) + "]";
  }
};

}  // namespace onggi::toml
