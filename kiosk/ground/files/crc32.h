#pragma once

#include <cstdint>
#include <span>

namespace onggi::files {

/// CRC-32 of IEEE 802.3 (reflected, 0xEDB88320, inverted at both ends) over `bytes`. `before`: the
/// result so far, for bytes in several parts. No allocation.
std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before = 0) noexcept;

}  // namespace onggi::files
