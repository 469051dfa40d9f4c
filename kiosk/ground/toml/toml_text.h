#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace onggi::toml {

/// Largest TOML file that is read, bytes.
inline constexpr std::size_t kLargestToml = 4u << 20;

/// The whole of `file`. Refuses what is not a regular file (a pipe would wait for ever) and what
/// is larger than kLargestToml. Never blocks on anything but the disk.
Result<std::string> read_toml_text(const std::filesystem::path& file);

/// Line `line` (from 1) of `text`, without its end, cut to `most` bytes at a whole character and
/// with control characters as '?': fit to be shown in a Problem.
std::string line_of(const std::string& text, std::size_t line, std::size_t most = 80);

/// `text` cut to `most` bytes at a whole character ("..." added then), control characters as '?'.
std::string shown(std::string_view text, std::size_t most);

}  // namespace onggi::toml
