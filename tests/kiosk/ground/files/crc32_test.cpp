#include "kiosk/ground/files/crc32.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace onggi::files::crc32_test {
namespace {

TEST(Crc32, IsThatOfIeee8023) {
  const std::string digits = "123456789";
  const std::vector<std::uint8_t> bytes(digits.begin(), digits.end());
  const std::span all(bytes);
  EXPECT_EQ(crc32(all), 0xCBF43926u);
  EXPECT_EQ(crc32(all.subspan(4), crc32(all.first(4))), 0xCBF43926u);
  EXPECT_EQ(crc32({}), 0u);
}

}  // namespace
}  // namespace onggi::files::crc32_test
