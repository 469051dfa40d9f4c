#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "engine/math/hash.h"
#include "engine/math/lowpass.h"
#include "engine/math/portable.h"
#include "engine/math/random.h"

namespace onggi::hash_random_lowpass_test {
namespace {

TEST(StateHash, OneBitOrAnotherOrderGivesAnotherHash) {
  std::set<std::uint64_t> seen;
  for (int bit = 0; bit < 64; ++bit) {
    for (int place = 0; place < 4; ++place) {
      StateHash hash;
      for (int n = 0; n < 4; ++n) hash.add(n == place ? std::uint64_t{1} << bit : std::uint64_t{0});
      seen.insert(hash.value());
    }
  }
  EXPECT_EQ(seen.size(), 256u);
}

TEST(StateHash, SeesEveryFloatOfAnOddRow) {
  std::array<float, 5> row{1, 2, 3, 4, 5};
  StateHash before;
  before.add(row);
  for (std::size_t n = 0; n < row.size(); ++n) {
    std::array<float, 5> other = row;
    other[n] += 0.5f;
    StateHash after;
    after.add(other);
    EXPECT_NE(before.value(), after.value());
  }
}

TEST(Random, IsEvenAndTheSameForTheSameSeed) {
  Random a(5);
  Random b(5);
  std::array<int, 10> bins{};
  for (int n = 0; n < 100000; ++n) {
    const double u = a.uniform();
    ASSERT_EQ(u, b.uniform());
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++bins[static_cast<std::size_t>(u * 10)];
  }
  for (int count : bins) EXPECT_NEAR(count, 10000, 400);
}

TEST(Lowpass, PassesRestAndIsThreeDecibelsDownAtItsCutoff) {
  Lowpass filter(100.0, 1000.0);
  double out = 0.0;
  for (int n = 0; n < 200; ++n) out = filter.filter(1.0);
  EXPECT_NEAR(out, 1.0, 1e-12);

  double most = 0.0;
  for (int n = 0; n < 5000; ++n) {
    // A quarter-sample grid would miss the peak at 10 samples a wave, so compare energies.
    const double y = filter.filter(portable::sin(2.0 * portable::kPi * 100.0 * n / 1000.0));
    if (n >= 1000) most += y * y;
  }
  EXPECT_NEAR(most / 4000.0, 0.5 * 0.5, 1e-3);  // half the input's mean square, twice over
}

TEST(Lowpass, SettledAtAValueStaysThere) {
  Lowpass filter(10.0, 1000.0);
  filter.settle(2.5);
  for (int n = 0; n < 100; ++n) EXPECT_NEAR(filter.filter(2.5), 2.5, 1e-12);
}

}  // namespace
}  // namespace onggi::hash_random_lowpass_test
