#include "engine/force/overspeed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::force::overspeed_test {
namespace {

bool seen(double speed, double seconds, int reports) {
  Overspeed overspeed;
  bool too_fast = false;
  for (int n = 0; n < reports; ++n)
    too_fast = overspeed.look({speed * seconds * n, 0, 0}, seconds) || too_fast;
  return too_fast;
}

TEST(Overspeed, IsFasterThanAnyHandThatWorksClay) {
  for (const double seconds : {0.0005, 0.001, 0.008}) {
    EXPECT_FALSE(seen(0.95 * Overspeed::kMost, seconds, 200)) << seconds;
    EXPECT_TRUE(seen(1.05 * Overspeed::kMost, seconds, 200)) << seconds;
  }
}

TEST(Overspeed, IsSeenWithinTwoReports) {
  Overspeed overspeed;
  EXPECT_FALSE(overspeed.look({}, 0.001));
  EXPECT_TRUE(overspeed.look({0.004, 0, 0}, 0.001));
}

TEST(Overspeed, ReportsThatCameTogetherAreNoSpeed) {
  Overspeed overspeed;
  overspeed.look({}, 0.001);
  EXPECT_FALSE(overspeed.look({0.001, 0, 0}, 0.0)) << "no time has passed";
  EXPECT_FALSE(overspeed.look({0.002, 0, 0}, 0.002));
}

TEST(Overspeed, AnEncodersStepIsNoSpeed) {
  Overspeed overspeed;
  for (int n = 0; n < 1000; ++n)
    EXPECT_FALSE(overspeed.look({n % 2 == 0 ? 0.0 : 5.5e-5, 0, 0}, 2e-5));
}

}  // namespace
}  // namespace onggi::force::overspeed_test
