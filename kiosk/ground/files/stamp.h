#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace onggi::files {

/// "SIZE TIME" of a regular file, links followed: another where it was written again. None where
/// there is no such file.
std::optional<std::string> stamp_of(const std::filesystem::path& file);

/// What stood where: the stamp of each file by its path, absolute and without dots.
using Stamps = std::map<std::filesystem::path, std::string>;

/// Of the files right in these folders. Reads no file's bytes. Any thread.
Stamps stamps_in(const std::vector<std::filesystem::path>& folders);

/// Those of `stamps` that are of `files`, one that is not among them left out.
Stamps of_files(const Stamps& stamps, const std::vector<std::filesystem::path>& files);

}  // namespace onggi::files
