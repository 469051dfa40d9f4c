#include "kiosk/ground/files/zstandard.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <span>
#include <vector>

namespace onggi::files::zstandard_test {
namespace {

std::vector<std::byte> some(std::size_t size) {
  std::vector<std::byte> bytes(size);
  for (std::size_t n = 0; n < size; ++n) bytes[n] = static_cast<std::byte>(n / 7 % 11);
  return bytes;
}

TEST(Zstandard, WhatWasPackedComesOutAndIsSmallerAndTheSameEachTime) {
  for (const std::size_t size : {0u, 1u, 100'000u}) {
    const auto bytes = some(size), frame = packed(bytes);
    EXPECT_TRUE(is_packed(frame));
    EXPECT_EQ(frame, packed(bytes));
    EXPECT_EQ(unpacked(frame, size), bytes);
  }
  EXPECT_LT(packed(some(100'000)).size(), 1000u);
  EXPECT_FALSE(is_packed(some(100)));
  EXPECT_FALSE(is_packed({}));
}

TEST(Zstandard, AFrameThatIsTooLargeCutOrDamagedGivesNothing) {
  const auto bytes = some(10'000), frame = packed(bytes);
  EXPECT_FALSE(unpacked(frame, 9'999));
  EXPECT_FALSE(unpacked({}, 10'000));
  EXPECT_TRUE(rc::check([&](std::uint16_t at, std::uint8_t bits) {
    auto other = frame;
    other[at % other.size()] ^= static_cast<std::byte>(bits | 1);
    const auto out = unpacked(other, 10'000);
    RC_ASSERT(!out || *out == bytes);
  }));
  for (std::size_t size = 0; size < frame.size(); ++size)
    EXPECT_FALSE(unpacked(std::span(frame).first(size), 10'000)) << size;
}

}  // namespace
}  // namespace onggi::files::zstandard_test
