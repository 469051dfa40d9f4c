#include "engine/math/crc64.h"

#include <array>

namespace onggi::checksum {
namespace {

constexpr std::uint64_t kPolynomial = 0xC96C5795D7870F42ULL;

constexpr std::array<std::uint64_t, 256> kTable = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::size_t n = 0; n < table.size(); ++n) {
    std::uint64_t rest = n;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1) != 0 ? kPolynomial : 0);
    table[n] = rest;
  }
  return table;
}();

}  // namespace

std::uint64_t crc64(std::span<const std::byte> bytes) noexcept {
  std::uint64_t crc = ~std::uint64_t{0};
  for (const std::byte byte : bytes)
    crc = kTable[(crc ^ static_cast<std::uint64_t>(byte)) & 0xFF] ^ (crc >> 8);
  return ~crc;
}

}  // namespace onggi::checksum
