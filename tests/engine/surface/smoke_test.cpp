#include "engine/surface/smoke.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::smoke_test {
namespace {

SmokeDef top() {
  SmokeDef def;
  def.from = 0.15;
  return def;
}

TEST(Smoke, BlackensTheTopAndTheInsideButNotTheFoot) {
  Surface surface = made(jar());
  done(surface, top());
  const int below = static_cast<int>((0.15 - 0.5 * 0.012 - 0.5 * 0.010) / 2.5e-4) - 1;
  const int above = static_cast<int>((0.15 + 0.5 * 0.012 + 0.5 * 0.010) / 2.5e-4) + 1;
  for (int i = 0; i < kSectors; ++i) {
    ASSERT_EQ(surface.smoke(below, i), 0);
    ASSERT_EQ(surface.smoke(above, i), kMostSmoke);
    ASSERT_EQ(surface.smoke(surface.rows() - 1, i), kMostSmoke);
  }
}

TEST(Smoke, ItsEdgeIsSoftAndWandersAndClosesRoundThePot) {
  Surface surface = made(jar());
  done(surface, top());
  std::vector<int> middle;
  for (int i = 0; i < kSectors; ++i) {
    int j = 0;
    while (surface.smoke(j, i) < 128) ++j;
    middle.push_back(j);
  }
  const auto [low, high] = std::minmax_element(middle.begin(), middle.end());
  EXPECT_GT(*high - *low, 12);  // 3 mm
  EXPECT_LE(*high - *low, 40);  // 10 mm
  for (int i = 0; i < kSectors; ++i)
    ASSERT_LE(std::abs(middle[static_cast<std::size_t>(i)] -
                       middle[static_cast<std::size_t>(wrapped(i + 1))]),
              1);
  for (int j = 1; j < surface.rows(); ++j) ASSERT_GE(surface.smoke(j, 9), surface.smoke(j - 1, 9));
}

TEST(Smoke, TwiceIsOnceAndAnotherSeedIsAnotherFire) {
  Surface a = made(jar()), b = made(jar());
  done(a, top());
  const std::uint64_t hash = a.hash();
  done(a, top());
  EXPECT_EQ(a.hash(), hash);
  SmokeDef other = top();
  other.seed = 2;
  done(b, other);
  EXPECT_NE(b.hash(), hash);
}

}  // namespace
}  // namespace onggi::surface_test::smoke_test
