#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"

namespace onggi::exhibit {

/// The folder that holds config/ and content/: the nearest one at or above the running program's,
/// then at or above the current folder.
Result<std::filesystem::path> program_root();

/// `given`, or config/exhibit.toml of program_root() when empty.
Result<std::filesystem::path> exhibit_file(const std::string& given);

}  // namespace onggi::exhibit
