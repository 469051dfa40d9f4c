#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "engine/base/result.h"

namespace onggi::files {

/// Writes all of `bytes` or nothing: temporary file in the same folder, fsync, rename, fsync of the
/// folder. After a power cut `file` holds either what it held before or all of `bytes`. A file that
/// was there gives its owner and rights to the new one; a link stays, and what it leads to is
/// written. Problem (exit 1) for a device, a pipe or a folder in its place, a folder that is not
/// there (make_folder()), a full disk, a read-only folder and the like, with what to do; the
/// temporary file is gone then. Blocks on the disk; any thread.
Result<void> write_durably(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Makes `folder` and what is missing above it, so that they outlast a power cut. Problem (exit 1).
Result<void> make_folder(const std::filesystem::path& folder);

/// Renames within one folder and fsyncs the folder. Problem (exit 1).
Result<void> rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

/// The Problem (exit 1) that errno value `error` means while `doing` ("write", "make") `path`.
Problem disk_problem(const std::filesystem::path& path, const char* doing, int error);

}  // namespace onggi::files
