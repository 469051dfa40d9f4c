#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace onggi::checksum {

/// CRC-64/XZ of `bytes`: polynomial of ECMA-182, reflected, inverted at both ends. No change within
/// 64 bits in a row goes unnoticed, so no changed byte; any other with a chance of 2^-64. No
/// allocation.
std::uint64_t crc64(std::span<const std::byte> bytes) noexcept;

}  // namespace onggi::checksum
