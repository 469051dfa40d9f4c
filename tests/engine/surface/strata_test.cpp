#include "engine/surface/strata.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::surface::strata_test {
namespace {

TEST(Strata, CodesAreQuarterOctavesFromTwoMicrometresToFourMillimetres) {
  EXPECT_EQ(thickness_of(0), 0);
  EXPECT_EQ(thickness_of(1), 2000);
  for (int code = 1; code < kCodes; ++code)
    EXPECT_NEAR(thickness_of(code), 2000.0 * std::exp2((code - 1) / 4.0),
                thickness_of(code) * 3e-4);
  EXPECT_EQ(thickness_of(kCodes - 1), 4096000);
}

TEST(Strata, TheCodeWithinIsTheThickestThatIsNotThicker) {
  EXPECT_EQ(code_within(-5), 0);
  EXPECT_EQ(code_within(1999), 0);
  for (int code = 1; code < kCodes; ++code) {
    EXPECT_EQ(code_within(thickness_of(code)), code);
    EXPECT_EQ(code_within(thickness_of(code) - 1), code - 1);
  }
  EXPECT_EQ(code_within(std::int64_t{1} << 60), kCodes - 1);
}

TEST(Strata, ThreeOfThemFitInOneWordWithTheirPigments) {
  Strata strata;
  const Stratum a{45, 15}, b{1, 7}, c{30, 0};
  strata.set(0, a), strata.set(1, b), strata.set(2, c);
  EXPECT_EQ(strata.at(0), a);
  EXPECT_EQ(strata.at(1), b);
  EXPECT_EQ(strata.at(2), c);
  EXPECT_EQ(strata.thickness(), thickness_of(45) + thickness_of(1) + thickness_of(30));
  strata.pop();
  EXPECT_EQ(strata.at(0), b);
  EXPECT_EQ(strata.at(2), Stratum{});
  strata.push();
  EXPECT_EQ(strata.at(0), Stratum{});
  EXPECT_EQ(strata.at(1), b);
  strata.set(1, {0, 9});
  EXPECT_EQ(strata.at(1), Stratum{});
}

}  // namespace
}  // namespace onggi::surface::strata_test
