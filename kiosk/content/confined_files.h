#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

using Bytes = std::vector<unsigned char>;

/// Reads a regular file of at most `most` bytes; anything else (a folder, a pipe, a device) is a
/// Problem. Never waits.
Result<Bytes> read_regular_file(const std::filesystem::path& file, std::size_t most);

/// Reads `uri` (percent-encoded, relative) beneath `folder` only: no absolute path, no "..", no
/// symbolic link on the way, and regular files only. `name` is the file that asks, for the Problem.
Result<Bytes> read_beneath(const std::filesystem::path& folder, const std::string& uri,
                           std::size_t most, const std::string& name);

}  // namespace onggi::content
