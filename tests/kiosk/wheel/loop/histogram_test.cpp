#include "kiosk/wheel/loop/histogram.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace onggi::loop::histogram_test {
namespace {

TEST(Histogram, AQuantileIsWhatASortedListSaysWithinThreePercent) {
  EXPECT_TRUE(rc::check([] {
    Histogram histogram;
    std::vector<double> all;
    for (const int value :
         *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 900000)))) {
      all.push_back(value + 0.5);
      histogram.add(all.back());
    }
    std::sort(all.begin(), all.end());
    for (const double share : {0.5, 0.9, 0.99, 0.9999, 1.0}) {
      const auto rank =
          static_cast<std::size_t>(std::ceil(share * static_cast<double>(all.size())));
      const double exact = all[std::max<std::size_t>(rank, 1) - 1];
      const double said = histogram.quantile(share);
      RC_ASSERT(said >= exact && said <= exact * (1.0 + 1.0 / 32.0) + 1.0);
    }
  }));
}

TEST(Histogram, EveryLengthLandsBelowTheUpperEndOfItsBinAndAboveTheOneBefore) {
  double before = 0.0;
  for (int bin = 0; bin + 1 < Histogram::kBins; ++bin) {
    const double end = Histogram::upper_end(bin);
    EXPECT_GT(end, before) << bin;
    Histogram one;
    one.add(before + 0.25);
    EXPECT_EQ(one.counts()[static_cast<std::size_t>(bin)], 1u) << bin;
    before = end;
  }
  Histogram none;
  EXPECT_EQ(none.quantile(0.5), 0.0);
  none.add(-3.0);
  none.add(1e12);
  EXPECT_EQ(none.total(), 2u);
  EXPECT_EQ(none.most(), 1e12);
}

}  // namespace
}  // namespace onggi::loop::histogram_test
