#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"

namespace onggi::files {

/// The folder that holds config/ and content/: the nearest one at or above the running program's,
/// then at or above the current folder.
Result<std::filesystem::path> program_root();

/// `given` (a folder: exhibit.toml in it). When empty, config/exhibit.toml of the site that the
/// current folder stands in, at or above it; else of program_root().
Result<std::filesystem::path> exhibit_file(const std::string& given);

/// config/exhibit.toml of the site that `path` lies in; empty where it lies in none.
std::filesystem::path site_exhibit(const std::filesystem::path& path);

/// Where the languages of the exhibit `file` lie: content/languages of its own site, else of the
/// program's. Empty where neither has any.
std::filesystem::path language_folder(const std::filesystem::path& file);

/// Where visits are counted: beside the keepsakes that lie in `folder`.
std::filesystem::path store_file(const std::filesystem::path& folder);

}  // namespace onggi::files
