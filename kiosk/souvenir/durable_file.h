#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "engine/base/result.h"

namespace onggi::souvenir {

/// Writes all of `bytes` or nothing: temporary file in the same folder, fsync, rename, fsync of the
/// folder. Makes the folder if need be. Problem (exit 1) for a full disk, a read-only folder and
/// the like, with what to do; the temporary file is gone then.
Result<void> write_durably(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace onggi::souvenir
