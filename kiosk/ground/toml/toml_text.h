#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace onggi::toml {

/// Largest TOML file that is read, bytes.
inline constexpr std::size_t kLargestToml = 4u << 20;

/// Reads all of `file`. Refuses files larger than kLargestToml and anything but regular files (a
/// pipe would wait forever). Blocks only on the disk.
Result<std::string> read_toml_text(const std::filesystem::path& file);

/// Refuses, with "file:line:column", what toml++ does not survive outside strings and comments:
/// - a name of more than 16 parts, `a.b.c...`: toml++ makes a table of each part and takes them
/// down
///   by recursion, and half a million parts, which fit into an allowed file, overflow the stack;
/// - a letter beyond ASCII. TOML has none there, but toml++ (3.3, 3.4) first asks whether the
/// letter
///   is a space, by a table of which it calls most entries unreachable: undefined behaviour.
Result<void> check_outside_quotes(const std::string& text, const std::string& file_name);

/// `text`, in which a letter beyond ASCII that follows a line end escaped by `\` in a """string"""
/// is written as \uXXXX or \UXXXXXXXX: toml++ asks of that letter, too, whether it is a space. What
/// is read is the same, and all lines keep their numbers; columns behind such a letter in its own
/// line do not.
std::string escaped_after_line_ends(const std::string& text);

/// Line `line` (from 1) of `text` without its end, ready to show in a Problem: cut to `most` bytes
/// at a whole character, with control characters as '?'.
std::string line_of(const std::string& text, std::size_t line, std::size_t most = 80);

/// `text` cut to `most` bytes at a whole character ("..." added then), control characters as '?'.
std::string shown(std::string_view text, std::size_t most);

}  // namespace onggi::toml
