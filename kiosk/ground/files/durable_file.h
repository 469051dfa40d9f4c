#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "engine/base/result.h"

namespace onggi::files {

/// Writes all of `bytes` or nothing: temporary file in the same folder, fsync, rename, fsync of the
/// folder. After a power cut `file` holds either its old content or all of `bytes`. Owner and
/// permissions of an old file are kept. A link is kept, and its target is written. Problem (exit
/// 1), with a remedy, for a device, pipe or folder in its place, a missing folder (make_folder()),
/// a full disk, a read-only folder and the like; the temporary file is removed. Blocks on the disk;
/// any thread.
Result<void> write_durably(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Creates `folder` and all missing parents so that they survive a power cut. Problem (exit 1).
Result<void> make_folder(const std::filesystem::path& folder);

/// Renames within one folder and fsyncs the folder. Problem (exit 1).
Result<void> rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

/// The Problem (exit 1) for errno value `error` while `doing` ("write", "make") `path`.
Problem disk_problem(const std::filesystem::path& path, const char* doing, int error);

}  // namespace onggi::files
