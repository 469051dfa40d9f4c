#include "kiosk/visit/screens/drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace onggi::screens::drift_test {
namespace {

TEST(Drift, ThePageWandersAPixelAtATimeOverTheWholeSquareAndNeverFar) {
  std::set<std::pair<int, int>> places;
  Drift before = drift(0, 65);
  EXPECT_EQ(before.x, 0);
  EXPECT_EQ(before.y, 0);
  int farthest = 0;
  double changed = 0;
  for (double t = 0; t < 72 * 3600.0; t += 10) {
    const Drift now = drift(t, 65);
    const int step = std::abs(now.x - before.x) + std::abs(now.y - before.y);
    ASSERT_LE(step, 2) << "nobody sees it";
    if (step > 0) changed = t;
    ASSERT_LE(t - changed, 300) << "it never rests";
    farthest = std::max({farthest, std::abs(now.x), std::abs(now.y)});
    places.insert({now.x, now.y});
    before = now;
  }
  EXPECT_EQ(farthest, 12);
  EXPECT_GT(places.size(), 400u) << "of 625, in three days";
}

TEST(Drift, ASmallPageKeepsThreeQuartersOfItsMargin) {
  for (double t = 0; t < 8 * 3600.0; t += 60) {
    EXPECT_LE(std::abs(drift(t, 20).x), 5);
    EXPECT_EQ(drift(t, 0).y, 0);
  }
}

}  // namespace
}  // namespace onggi::screens::drift_test
