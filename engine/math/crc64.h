#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace onggi::checksum {

/// CRC-64/XZ of `bytes`: polynomial of ECMA-182, reflected, inverted at both ends. It always
/// detects a change within 64 consecutive bits, so every changed byte; other changes are missed
/// with a chance of 2^-64. No allocation.
std::uint64_t crc64(std::span<const std::byte> bytes) noexcept;

}  // namespace onggi::checksum
