#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "kiosk/collection/textures/texture_decoder.h"

namespace onggi::textures {

/// Why a picture of this size is refused; nothing if it is accepted.
std::optional<std::string> fault_of_size(std::uint64_t width, std::uint64_t height, unsigned most);

/// Each decoder reads the header first, and allocates only after fault_of_size() accepts the size.
Decoded decode_png(std::span<const std::uint8_t> bytes, unsigned most_side);
Decoded decode_jpeg(std::span<const std::uint8_t> bytes, unsigned most_side);
Decoded decode_webp(std::span<const std::uint8_t> bytes, unsigned most_side);

}  // namespace onggi::textures
