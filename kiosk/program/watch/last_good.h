#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/result.h"

namespace onggi::watch {

/// A copy of a site (config/ and content/) that ran for an hour without a crash.
struct LastGood {
  std::filesystem::path exhibit;    ///< Its config/exhibit.toml.
  std::filesystem::path keepsakes;  ///< Its keepsake folder, absolute: keepsakes continue there.
};

/// "PATH SIZE TIME", one sorted line for each file of config/ and content/ of `site`; equal texts
/// mean equal files. Links are followed; no file is read. Problem (exit 1): the disk.
Result<std::string> files_of(const std::filesystem::path& site);

/// Copies config/ and content/ of `site` into `folder`/last_good and replaces the old copy,
/// completely or not at all. False, and nothing is copied, if they are no longer the `files` that
/// were shown. Does nothing if that copy exists. Problem (exit 1): the disk. Reads and writes the
/// whole site; not for the main thread.
Result<bool> keep_last_good(const std::filesystem::path& site, const std::string& files,
                            const std::filesystem::path& keepsakes,
                            const std::filesystem::path& folder);

/// The saved copy.
std::optional<LastGood> last_good(const std::filesystem::path& folder);

/// Records in `folder` the keepsake folder, absolute, for a run that finds no exhibit of its own.
/// Problem (exit 1): the disk.
Result<void> remember_keepsakes(const std::filesystem::path& keepsakes,
                                const std::filesystem::path& folder);
/// The recorded keepsake folder; none if nothing is recorded.
std::optional<std::filesystem::path> remembered_keepsakes(const std::filesystem::path& folder);

}  // namespace onggi::watch
