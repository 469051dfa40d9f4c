#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"

namespace onggi::tuning {

/// The text of a scene's TOML with another grid: replaces clay.rows and clay.sectors, with `note`
/// as a comment, removes quality = "auto", and keeps every other byte. A missing [clay] is added at
/// the end.
std::string with_grid(const std::string& toml, int rows, int sectors, const std::string& note);

/// Writes it into `file` durably, and reads it back. Problem if the file is not a scene before, or
/// (exit 1) after; it is then unchanged.
Result<void> write_grid(const std::filesystem::path& file, int rows, int sectors,
                        const std::string& note);

}  // namespace onggi::tuning
