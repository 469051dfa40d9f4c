#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "engine/base/result.h"

namespace onggi::archives {

/// How much of an archive is unpacked; beyond that it is refused.
struct UnpackLimits {
  std::size_t entries = 2000;                      ///< Files and folders.
  std::uint64_t bytes = std::uint64_t{2} << 30;    ///< Of all files together, unpacked.
  std::size_t depth = 16;                          ///< Folders within folders.
  std::uint64_t reserve = std::uint64_t{1} << 30;  ///< Bytes that stay free on the disk.
};

/// True if the file name ends in .zip.
bool is_archive_ending(const std::filesystem::path& file);

/// Unpacks the zip `file` into `folder`, which is made and must not be there yet; its parent must.
/// All or nothing: with a Problem there is no such folder. What an operating system adds
/// (is_litter()) is left out. Problem, exit 2, for a name that leads out or is there twice
/// (EntryNames), a link or a special file, an encrypted entry, a packing other than stored and
/// deflated, more than a limit, bytes that are not those of the checksum or more than the archive
/// claims; exit 1 where the disk refuses. Holds a piece of 64 KiB. Blocks on the disk; any thread.
Result<void> unpack(const std::filesystem::path& file, const std::filesystem::path& folder,
                    const UnpackLimits& limits = {});

}  // namespace onggi::archives
