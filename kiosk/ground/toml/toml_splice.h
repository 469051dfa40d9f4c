#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "kiosk/ground/toml/toml_places.h"

namespace onggi::toml {

/// A TOML text with one value changed.
struct Spliced {
  std::string text;     ///< All of it.
  std::size_t at = 0;   ///< Where the change begins.
  std::string was, is;  ///< What stood there, and what stands there now.
  bool added = false;   ///< The key was absent.
};

/// `text` with `value` (as TOML writes it: `90`, `"Onggi"`, `["en", "ko"]`) at `path`; every other
/// byte stays: comments, order, ends of lines, a byte order mark.
/// - A key that is absent gets a line of its own behind the last key of its table, or behind a
///   comment that shows it (`# key = ...`); in an inline table a place behind the last one.
/// - A table that is absent is written at the end. An element of a list is never added.
/// The result is parsed, and differs from `text` in that value alone. Problem, called `name`, where
/// `text` or `value` is no TOML, or the value cannot stand there. Allocates; any thread.
Result<Spliced> with_value(const std::string& text, const Path& path, const std::string& value,
                           const std::string& name);

/// `text` without the value at `path`: its statement goes with the comment behind it, and the
/// [table] line that would stand above nothing. All else stays. Nothing changes where there is no
/// such value. Problem, called `name`, where `text` is no TOML or the value stands within {...}.
Result<Spliced> without_value(const std::string& text, const Path& path, const std::string& name);

/// True if `text` is one TOML value, and nothing else.
bool is_value(const std::string& text);

/// `text` in "quotes", as TOML writes it.
std::string quoted_text(std::string_view text);

/// `path` as a person types it: names with points between them, quotes where a name needs them.
std::string key_text(const Path& path);

/// What key_text() wrote, or a person typed. Empty if it cannot be read.
Path path_of(std::string_view key);

}  // namespace onggi::toml
