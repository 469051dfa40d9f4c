#include "engine/scene/replay_columns.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <string>
#include <vector>

#include "engine/math/random.h"

namespace onggi::replay_bytes::replay_columns_test {
namespace {

using Bytes = std::vector<std::byte>;
using Bits = std::vector<std::uint64_t>;

Bytes written(const Bits& bits) {
  Bytes bytes;
  Writer io(bytes);
  write_numbers(io, bits);
  return bytes;
}

bool comes_back(const Bits& bits) {
  const Bytes bytes = written(bits);
  Reader io(bytes);
  Bits back(bits.size());
  return read_numbers(io, back) && io.left() == 0 && back == bits;
}

Bits bits_of(const std::vector<double>& numbers) {
  Bits bits;
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

/// Bytes of a column that are not zero: about what a packer has to keep.
double filled_bytes_each(const Bits& bits) {
  const Bytes bytes = written(bits);
  const auto zeros = std::count(bytes.begin(), bytes.end(), std::byte{0});
  return static_cast<double>(static_cast<long>(bytes.size()) - zeros) /
         static_cast<double>(bits.size());
}

RC_GTEST_PROP(ReplayNumbers, AnyBitsComeBack, (const Bits& bits)) { RC_ASSERT(comes_back(bits)); }

RC_GTEST_PROP(ReplayNumbers, AnyDoublesComeBackBitForBit, (const std::vector<double>& numbers)) {
  RC_ASSERT(comes_back(bits_of(numbers)));
}

TEST(ReplayNumbers, EveryOddDoubleComesBackBehindEveryOther) {
  using Limits = std::numeric_limits<double>;
  const Bits odd = [] {
    Bits all = bits_of({0.0, -0.0, 1.0, -1.0, Limits::min(), -Limits::min(), Limits::max(),
                        Limits::lowest(), Limits::denorm_min(), -Limits::denorm_min(),
                        Limits::infinity(), -Limits::infinity(), 0.1, 1e300, 5e-324});
    for (const std::uint64_t nan : {0x7FF8000000000000u, 0xFFF8000000000000u, 0x7FF0000000000001u,
                                    0xFFFFFFFFFFFFFFFFu, 0x7FF8DEADBEEF0001u})
      all.push_back(nan);
    return all;
  }();
  for (const std::uint64_t a : odd)
    for (const std::uint64_t b : odd)
      for (const std::uint64_t c : odd) ASSERT_TRUE(comes_back({a, b, c, a})) << a << ' ' << b;
}

TEST(ReplayNumbers, NoneAndOneComeBack) {
  EXPECT_TRUE(written({}).empty());
  EXPECT_TRUE(comes_back({}));
  EXPECT_TRUE(comes_back(bits_of({0.25})));
}

TEST(ReplayNumbers, AMillionComeBack) {
  Random random(3);
  Bits bits;
  double at = 0.0;
  for (int n = 0; n < 1'000'000; ++n) {
    at += random.uniform(-1e-5, 1e-5);
    bits.push_back(n % 1000 == 999 ? random.bits() : std::bit_cast<std::uint64_t>(at));
  }
  EXPECT_TRUE(comes_back(bits));
}

// Four of five bytes of a hand at random places are filled.
TEST(ReplayNumbers, AnEvenMotionAndOneThatSettlesLeaveNextToNothing) {
  std::vector<double> even, settling, wild;
  Random random(8);
  double at = 0.05, target = 0.06;
  for (int n = 0; n < 20'000; ++n) {
    even.push_back(0.05 + 1e-6 * n);
    if (n % 100 == 0) target = random.uniform(0.0, 0.1);
    at += (target - at) / 26.0;
    settling.push_back(at);
    wild.push_back(random.uniform(-0.1, 0.1));
  }
  EXPECT_LT(filled_bytes_each(bits_of(even)), 1.0);
  EXPECT_LT(filled_bytes_each(bits_of(settling)), 1.1);
  EXPECT_GT(filled_bytes_each(bits_of(wild)), 4.0);
}

RC_GTEST_PROP(ReplayNumbers, ACutColumnIsRefused, (std::uint64_t seed)) {
  Random random(seed);
  Bits bits(1 + random.bits() % 40);
  for (std::uint64_t& one : bits) one = random.bits();
  Bytes bytes = written(bits);
  bytes.resize(random.bits() % bytes.size());
  Reader io(bytes);
  RC_ASSERT(!read_numbers(io, bits));
}

// A rate is written in the column, so damage can make it anything.
TEST(ReplayNumbers, AnyRateIsRead) {
  Bits bits = bits_of({0.1, 0.2, 0.3, 0.4});
  for (const double rate : {std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity(), 1e308, -1.0}) {
    Bytes bytes = written(bits);
    const auto other = std::bit_cast<std::uint64_t>(rate);
    for (std::size_t k = 0; k < 8; ++k) bytes[k] = static_cast<std::byte>(other >> (8 * k));
    Reader io(bytes);
    EXPECT_TRUE(read_numbers(io, bits)) << rate;
  }
}

TEST(ReplayColumns, CutOnesAndAFieldThatTheirVersionDoesNotKnowAreRefused) {
  Columns columns;
  columns.fields = {0, kHand0, 0};
  for (std::size_t n = 0; n < 3; ++n) columns.numbers[n] = bits_of({0.5});
  Bytes bytes;
  Writer writer(bytes);
  write_columns(writer, columns);
  const auto good = [](const Bytes& all, std::uint32_t version = kVersion) {
    Reader io(all);
    Columns back;
    return read_columns(io, version, back);
  };
  EXPECT_TRUE(good(bytes));
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));
    EXPECT_FALSE(good(cut)) << n;
  }
  EXPECT_TRUE(good(bytes, kFirstSwings - 1));
  columns = {};
  columns.fields = {kSwings};
  for (std::size_t n = kNumbers - 4; n < kNumbers; ++n) columns.numbers[n] = bits_of({0.5});
  bytes.clear();
  write_columns(writer, columns);
  EXPECT_TRUE(good(bytes));
  EXPECT_FALSE(good(bytes, kFirstSwings - 1)) << "a field that came later";
}

}  // namespace
}  // namespace onggi::replay_bytes::replay_columns_test
