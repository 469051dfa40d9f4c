#pragma once

#include <cstddef>
#include <filesystem>

namespace onggi::console {

/// Removes all files of `folder` but the newest `most`. Blocks on the disk.
void keep_newest(const std::filesystem::path& folder, std::size_t most);

}  // namespace onggi::console
