#include "engine/math/crc64.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

namespace onggi::checksum::crc64_test {
namespace {

std::uint64_t of(const std::string& text) { return crc64(std::as_bytes(std::span(text))); }

TEST(Crc64, GivesTheCheckValuesThatAreKnownOfIt) {
  EXPECT_EQ(of(""), 0u);
  EXPECT_EQ(of("123456789"), 0x995DC9BBDF1939FAULL);
  // Of xz's own tests.
  EXPECT_EQ(of("a"), 0x330284772E652B05ULL);
}

// A bit at a time, as its definition says.
std::uint64_t plain(std::span<const std::byte> bytes) {
  std::uint64_t crc = ~std::uint64_t{0};
  for (const std::byte byte : bytes) {
    crc ^= static_cast<std::uint64_t>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xC96C5795D7870F42ULL : 0);
  }
  return ~crc;
}

TEST(Crc64, IsWhatItsDefinitionSaysAtEveryLength) {
  std::vector<std::byte> bytes;
  for (std::size_t n = 0; n < 70; ++n) {
    ASSERT_EQ(crc64(bytes), plain(bytes)) << n;
    bytes.push_back(static_cast<std::byte>(n * n + 91));
  }
}

TEST(Crc64, NoticesEveryChangeOfOneByteAndEverySwap) {
  std::vector<std::byte> bytes(200);
  for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<std::byte>(n * 37);
  const std::uint64_t whole = crc64(bytes);
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (unsigned flip = 1; flip < 256; ++flip) {
      bytes[n] ^= static_cast<std::byte>(flip);
      ASSERT_NE(crc64(bytes), whole) << n << " " << flip;
      bytes[n] ^= static_cast<std::byte>(flip);
    }
  for (std::size_t n = 1; n < bytes.size(); ++n) {
    std::swap(bytes[n - 1], bytes[n]);
    ASSERT_NE(crc64(bytes), whole) << n;
    std::swap(bytes[n - 1], bytes[n]);
  }
}

}  // namespace
}  // namespace onggi::checksum::crc64_test
