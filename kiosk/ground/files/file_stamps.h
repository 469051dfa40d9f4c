#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace onggi::files {

/// "SIZE TIME" of a regular file, links followed. It changes when the file is written again. None
/// if there is no such file.
std::optional<std::string> stamp_of(const std::filesystem::path& file);

/// The stamp of each file by its absolute path without dots.
using Stamps = std::map<std::filesystem::path, std::string>;

/// Stamps of the files directly in these folders. Does not read their bytes. Any thread.
Stamps stamps_in(const std::vector<std::filesystem::path>& folders);

/// The stamps of `files` only; files without a stamp are left out.
Stamps of_files(const Stamps& stamps, const std::vector<std::filesystem::path>& files);

}  // namespace onggi::files
