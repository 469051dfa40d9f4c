#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/result.h"

namespace onggi::watch {

/// A site (config/ and content/) that visitors had for an hour without a crash, copied aside.
struct LastGood {
  std::filesystem::path exhibit;    ///< Its config/exhibit.toml.
  std::filesystem::path keepsakes;  ///< Where its keepsakes went, absolute: they go on there.
};

/// "PATH SIZE TIME", a line for each file of config/ and content/ of `site`, in order: equal texts
/// are equal files. Links are followed; no file's bytes are read. Problem (exit 1): the disk.
Result<std::string> files_of(const std::filesystem::path& site);

/// Copies config/ and content/ of `site` into `folder`/last_good, in place of what was there, whole
/// or not at all. False, and nothing is done, where they are no longer the `files` that were shown.
/// Does nothing where that copy is there already. Problem (exit 1): the disk. Reads and writes as
/// many bytes as the site has; not for the main thread.
Result<bool> keep_last_good(const std::filesystem::path& site, const std::string& files,
                            const std::filesystem::path& keepsakes,
                            const std::filesystem::path& folder);

/// What was kept there.
std::optional<LastGood> last_good(const std::filesystem::path& folder);

/// Remembers in `folder` where keepsakes go, absolute, for a run that finds no exhibit of its own.
/// Problem (exit 1): the disk.
Result<void> remember_keepsakes(const std::filesystem::path& keepsakes,
                                const std::filesystem::path& folder);
/// Where they went last; none where nothing is remembered.
std::optional<std::filesystem::path> remembered_keepsakes(const std::filesystem::path& folder);

}  // namespace onggi::watch
