#pragma once

#include <cstdint>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device {

/// CRC-32 of IEEE 802.3 (reflected, 0xEDB88320, inverted at both ends) over `bytes`. `before`: the
/// result so far, for bytes in several parts. No allocation.
std::uint32_t crc32(Report bytes, std::uint32_t before = 0) noexcept;

}  // namespace onggi::device
