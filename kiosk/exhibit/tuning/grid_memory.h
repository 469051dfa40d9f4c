#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "kiosk/exhibit/tuning/tuner.h"

namespace onggi::tuning {

/// The file in `folder` for the grid of the scene in `scene_file` on the machine of that name; the
/// file's name depends on both, so another machine or a changed scene has another file. Problem if
/// the scene cannot be read.
Result<std::filesystem::path> memory_of(const std::filesystem::path& folder,
                                        const std::filesystem::path& scene_file,
                                        const std::string& machine);

/// The saved grid; absent if there is none, or if it is invalid.
std::optional<TunedGrid> remembered(const std::filesystem::path& memory);
/// Saves it durably, with `machine` for people to read.
Result<void> remember(const std::filesystem::path& memory, const TunedGrid& grid,
                      const std::string& machine);

}  // namespace onggi::tuning
