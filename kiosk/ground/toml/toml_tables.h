#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/toml/toml_places.h"

namespace onggi::toml {

/// A TOML text with one table more or less.
struct TableSpliced {
  std::string text;     ///< All of it.
  std::string was, is;  ///< The bytes that were taken out, or put in.
};

/// `text` with an empty `[path]` at its end. Every other byte stays, and so does the whole text
/// where the table is there already. Problem, called `name`, where `text` is no TOML or something
/// else stands at `path`. Allocates; any thread.
Result<TableSpliced> with_table(const std::string& text, const Path& path, const std::string& name);

/// `text` with one more element `[[list]]` at its end, of which only `id` is written. Likewise.
Result<TableSpliced> with_element(const std::string& text, const Path& list, const std::string& id,
                                  const std::string& name);

/// `text` without the table at `path`, or without the element {"mission", "2"} of a list: its line,
/// all that stands below it, tables within it, and the comment right above it, unless that begins
/// the file. Every other byte stays, and so does the whole text where there is no such table.
/// Likewise.
Result<TableSpliced> without_table(const std::string& text, const Path& path,
                                   const std::string& name);

}  // namespace onggi::toml
