#include "kiosk/ground/files/crc32.h"

#include <array>

namespace onggi::files {

namespace {

constexpr std::array<std::uint32_t, 16> kNibbles = [] {
  std::array<std::uint32_t, 16> table{};
  for (std::uint32_t n = 0; n < 16; ++n) {
    std::uint32_t c = n;
    for (int bit = 0; bit < 4; ++bit) c = (c & 1) != 0 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}();

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before) noexcept {
  std::uint32_t c = ~before;
  for (const std::uint8_t byte : bytes) {
    c ^= byte;
    c = kNibbles[c & 15] ^ (c >> 4);
    c = kNibbles[c & 15] ^ (c >> 4);
  }
  return ~c;
}

}  // namespace onggi::files
