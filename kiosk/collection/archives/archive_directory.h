#pragma once

#include <cstddef>
#include <filesystem>

#include "engine/base/result.h"

namespace onggi::archives {

/// Looks at the directory at the end of the zip `file` before a library reads it. A library takes
/// memory for as many entries as an archive claims, and ends a name at its first zero byte.
/// Problem: no regular file, no directory, more than `most` entries or a directory too long for
/// them, a zero byte in a name. Takes at most 2 KiB for each of `most` entries. Blocks on the disk;
/// any thread.
Result<void> check_directory(const std::filesystem::path& file, std::size_t most);

}  // namespace onggi::archives
