#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/reader_limits.h"
#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::content {

/// Decodes a file's pictures with the helper program onggi-texture beside this program, which has
/// its own memory and time. Each picture is reduced to at most 1024 pixels a side, fewer if there
/// are many. Problem for all of them if the helper could not start or failed. Blocks; starts a
/// process if there is a picture. Allocates.
Result<std::vector<textures::Decoded>> read_textures(
    const std::vector<std::span<const std::uint8_t>>& pictures,
    const settings::ReaderLimits& limits);

}  // namespace onggi::content
