#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/reader_limits.h"
#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::content {

/// Decodes a file's pictures by the helper program onggi-texture, which lies beside this one and
/// has its own memory and time; each comes with 1024 pixels a side at the most, fewer where there
/// are many. The Problem is of all of them: the helper could not be had, or did not end well.
/// Blocks; starts a process where there is a picture. Allocates.
Result<std::vector<textures::Decoded>> read_textures(
    const std::vector<std::span<const std::uint8_t>>& pictures,
    const settings::ReaderLimits& limits);

}  // namespace onggi::content
