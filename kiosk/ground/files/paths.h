#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"

namespace onggi::files {

/// The folder that holds config/ and content/: the nearest one at or above the running program's,
/// then at or above the current folder.
Result<std::filesystem::path> program_root();

/// `given`, or exhibit.toml in it if it is a folder. If `given` is empty: config/exhibit.toml of
/// the site at or above the current folder, else of program_root().
Result<std::filesystem::path> exhibit_file(const std::string& given);

/// config/exhibit.toml of the site that contains `path`; empty if no site does.
std::filesystem::path site_exhibit(const std::filesystem::path& path);

/// The language folder of the exhibit `file`: content/languages of its own site, else of the
/// program. Empty if neither has one.
std::filesystem::path language_folder(const std::filesystem::path& file);

/// `path` with its links followed, as far as it is there, absolute, without a slash at its end.
std::filesystem::path real_path(const std::filesystem::path& path);
/// True if `inner` is `outer` or lies in it, links followed.
bool is_within(const std::filesystem::path& inner, const std::filesystem::path& outer);

/// The file of visit counts, beside the keepsakes in `folder`.
std::filesystem::path store_file(const std::filesystem::path& folder);

}  // namespace onggi::files
