#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/scene/replay.h"

namespace onggi::files {

/// Reads a visit.onggi, packed or, as onggi wrote it before 2026-12, not. Problem where there is
/// none, it is over 1 GiB or damaged. Allocates.
Result<Replay> read_replay(const std::filesystem::path& file);

}  // namespace onggi::files
