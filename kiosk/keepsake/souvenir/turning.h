#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/picture/encoding/encode.h"

namespace onggi::souvenir {

/// Largest turning picture, bytes: it fits into a message.
inline constexpr std::size_t kMostOfATurning = 2'200'000;

/// `turning` as a GIF of at most `most` bytes. A pot with too much detail turns in every second of
/// its pictures, or every fourth, with the same duration. Problem (exit 1) as from encode(), or if
/// that is still too large. Blocks.
Result<std::vector<std::byte>> turning_picture(const encoding::Turning& turning,
                                               const encoding::Caption& caption,
                                               std::size_t most = kMostOfATurning);

/// Adds `gif` to the visit in folder `visit`, then tidies around it. It is complete or absent even
/// after a power cut, and nothing else of the visit changes. If the visit was deleted meanwhile (by
/// its visitor, or for the quota): Problem, exit 1, and nothing of `gif` is left. Blocks; not while
/// another thread writes to the same folder of keepsakes.
Result<std::filesystem::path> add_turning(const std::filesystem::path& visit,
                                          std::span<const std::byte> gif,
                                          const KeepsakeLimits& limits);

}  // namespace onggi::souvenir
