#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/picture/encoding/encode.h"

namespace onggi::souvenir {

/// What a turning picture is at the most: what goes into a message. Bytes.
inline constexpr std::size_t kMostOfATurning = 4'000'000;

/// `turning` as a GIF of no more than `most` bytes: a pot that is too busy for that turns as long
/// in every second of its pictures, or every fourth. Problem (exit 1) as encode(); and where that
/// is too much too. Blocks.
Result<std::vector<std::byte>> turning_picture(const encoding::Turning& turning,
                                               const encoding::Caption& caption,
                                               std::size_t most = kMostOfATurning);

/// Adds `gif` to the visit that was kept in folder `visit`, then tidies around it. It is there
/// whole or not at all, whenever the power goes, and nothing else of the visit is touched. One that
/// has gone meanwhile (deleted by its visitor, or for the quota) gets nothing: Problem, exit 1, and
/// none of `gif` is left. Blocks; not while another writes the same folder of keepsakes.
Result<std::filesystem::path> add_turning(const std::filesystem::path& visit,
                                          std::span<const std::byte> gif,
                                          const KeepsakeLimits& limits);

}  // namespace onggi::souvenir
