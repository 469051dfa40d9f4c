#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "kiosk/exhibit/tuning/tuner.h"

namespace onggi::tuning {

/// Where the grid of the scene in `scene_file` on the machine of that name is kept: a text file
/// of `folder`, whose name carries both. Another machine, or a scene that says something else, has
/// another. Problem where the scene cannot be read.
Result<std::filesystem::path> memory_of(const std::filesystem::path& folder,
                                        const std::filesystem::path& scene_file,
                                        const std::string& machine);

/// The grid that is kept there; none where nothing is, or nothing that makes sense.
std::optional<TunedGrid> remembered(const std::filesystem::path& memory);
/// Keeps it durably, with `machine` for a person to read.
Result<void> remember(const std::filesystem::path& memory, const TunedGrid& grid,
                      const std::string& machine);

}  // namespace onggi::tuning
