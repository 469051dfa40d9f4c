#pragma once

#include <filesystem>

namespace onggi::files {

/// Where a group may write in the folder above, it may write in `folder` too: programs of several
/// users delete there what one of them made. Changes nothing else, and nothing where this user is
/// not the owner or not of that group.
void share_as_above(const std::filesystem::path& folder);

}  // namespace onggi::files
