#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace onggi::watch {

/// "SIZE TIME" of a regular file, links followed: another where it was written again. None where
/// there is no such file.
std::optional<std::string> stamp_of(const std::filesystem::path& file);

/// A line "PATH STAMP" for each file right in these folders, sorted: equal texts are equal files.
/// Reads no file's bytes. Any thread.
std::string stamps_in(const std::vector<std::filesystem::path>& folders);

}  // namespace onggi::watch
