#pragma once

#include <map>
#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/toml/toml_places.h"

namespace onggi::console {

/// What stands in which line of a TOML text: read once, since a text may have hundreds of faults.
/// `text` must outlive it. Any thread.
class LineKeys {
 public:
  /// `name`: of the file, as its Problems begin: "name:12:3".
  LineKeys(const std::string& text, std::string name);

  const toml::TomlPlaces& places() const { return places_; }
  /// The value in the line that `problem` is about, or null.
  const toml::TomlPlaces::Value* value_at(const Problem& problem) const;
  /// The [table] or [[table]] in that line, or null.
  const toml::TomlPlaces::Header* header_at(const Problem& problem) const;

 private:
  std::size_t line_of(const Problem& problem) const;

  toml::TomlPlaces places_;
  std::string name_;
  std::map<std::size_t, const toml::TomlPlaces::Value*> values_;
  std::map<std::size_t, const toml::TomlPlaces::Header*> headers_;
};

}  // namespace onggi::console
