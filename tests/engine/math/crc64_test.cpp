#include "engine/math/crc64.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace onggi::checksum {
namespace {

std::uint64_t of(const std::string& text) { return crc64(std::as_bytes(std::span(text))); }

TEST(Crc64, GivesTheCheckValuesThatAreKnownOfIt) {
  EXPECT_EQ(of(""), 0u);
  EXPECT_EQ(of("123456789"), 0x995DC9BBDF1939FAULL);
  // Of xz's own tests.
  EXPECT_EQ(of("a"), 0x330284772E652B05ULL);
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
}  // namespace onggi::checksum
