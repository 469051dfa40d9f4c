#pragma once

#include <filesystem>
#include <optional>

#include "engine/base/result.h"

namespace onggi::watch {

/// A site (config/ and content/) that visitors had for an hour without a crash, copied aside.
struct LastGood {
  std::filesystem::path exhibit;    ///< Its config/exhibit.toml.
  std::filesystem::path keepsakes;  ///< Where its keepsakes went, absolute: they go on there.
};

/// Copies config/ and content/ of `site` into `folder`/last_good, in place of what was there, whole
/// or not at all. Does nothing where that holds the same files, by name, size and time. Links are
/// followed. Problem (exit 1): the disk. Reads and writes as many bytes as the site has; not for
/// the main thread.
Result<void> keep_last_good(const std::filesystem::path& site,
                            const std::filesystem::path& keepsakes,
                            const std::filesystem::path& folder);

/// What was kept there.
std::optional<LastGood> last_good(const std::filesystem::path& folder);

}  // namespace onggi::watch
