#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"

namespace onggi::tuning {

/// The text of a scene's TOML with another grid: clay.rows and clay.sectors are written anew with
/// `note` as a comment, quality = "auto" is taken out, and every other byte stays. A [clay] that is
/// not there is put at the end.
std::string with_grid(const std::string& toml, int rows, int sectors, const std::string& note);

/// Writes it into `file` durably, and reads it back: a Problem where the file is no scene, before
/// or (exit 1) after, and then the file is as it was.
Result<void> write_grid(const std::filesystem::path& file, int rows, int sectors,
                        const std::string& note);

}  // namespace onggi::tuning
