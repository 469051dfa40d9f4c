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

/// Line `line` (from 1) of `text` without its end, ready to show in a Problem: cut to `most` bytes
/// at a whole character, with control characters as '?'.
std::string line_of(const std::string& text, std::size_t line, std::size_t most = 80);

/// `text` cut to `most` bytes at a whole character ("..." added then), control characters as '?'.
std::string shown(std::string_view text, std::size_t most);

/// Behind the string that begins at `begin`, of any of TOML's four kinds; at the end of its line,
/// or of `text`, where it is not closed.
std::size_t behind_string(std::string_view text, std::size_t begin);

}  // namespace onggi::toml
