#pragma once

// Inside of TomlReader, for its own sources only.

#include <algorithm>
#include <map>

#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_text.h"
#include "kiosk/ground/toml/toml_tree.h"

namespace onggi::toml {

struct TomlReader::Impl {
  std::string name;  // as it was given, for every Problem
  TomlNode::Table root;
  bool ok = false;
  std::vector<Problem> problems;
  std::vector<Place> places;  // of each Problem: both are kept in file order
  std::map<std::string, std::shared_ptr<Table::Impl>> tables;  // by path
  int keys_checked = 0;

  std::string where(Place at) const {
    return name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
  }
  void note(Place at, std::string what, std::string remedy) {
    if (!ok) return;  // the parser has already reported the error
    const auto after = std::upper_bound(places.begin(), places.end(), at);
    problems.insert(problems.begin() + (after - places.begin()),
                    Problem{where(at), std::move(what), std::move(remedy)});
    places.insert(after, at);
  }
  Table table(const std::string& path, const TomlNode::Table* node, Place at);
};

struct TomlReader::Table::Impl {
  TomlReader::Impl* file = nullptr;
  const TomlNode::Table* node = nullptr;  // null: absent
  std::string path;                       // "" is the root
  Place place;
  std::vector<std::string> asked;
  bool finished = false;

  std::string full(std::string_view key) const {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
  }
  /// The value of `key`, or null. Records that it was asked for.
  const TomlNode* ask(std::string_view key) {
    const TomlNode* value = node == nullptr ? nullptr : find(*node, key);
    if (std::find(asked.begin(), asked.end(), key) == asked.end()) {
      asked.emplace_back(key);
      if (value != nullptr && value->as<TomlNode::Table>() == nullptr &&
          !value->is_list_of_tables()) {
        ++file->keys_checked;
      }
    }
    return value;
  }
  Place place_of_key(std::string_view key) const {
    const TomlNode* value = key.empty() || node == nullptr ? nullptr : find(*node, key);
    return value == nullptr ? place : value->place;
  }
  void wrong_type(std::string_view key, const TomlNode& value, const std::string& wanted,
                  std::string remedy);
  void out_of_range(std::string_view key, const TomlNode& value, double low, double high,
                    std::string_view unit, const std::string& remedy);
  /// The list at `key`; notes a Problem if the value is not a list.
  const TomlNode::List* ask_list(std::string_view key, const std::string& wanted,
                                 const std::string& remedy);
  /// What to write instead of the key `wrong`, as a sentence.
  std::string right_name(const std::string& wrong) const;
  std::string element(std::string_view key, std::size_t index) const {
    return std::string(key) + "[" + std::to_string(index) + "]";
  }
};

}  // namespace onggi::toml
