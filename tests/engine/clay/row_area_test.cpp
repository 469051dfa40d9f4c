#include "engine/clay/row_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/math/random.h"

namespace onggi::clay::row_area_test {
namespace {

TEST(RowArea, IsTheRingsOfAllElementsTheSameBitsOnAllVectors) {
  Random random(3);
  for (const int width : {16, 17, 23, 24, 27, 360, 2879}) {
    std::vector<float> outer, inner;
    long double sum = 0.0L;
    for (int i = 0; i < width; ++i) {
      inner.push_back(static_cast<float>(random.uniform(0.0, 0.1)));
      outer.push_back(inner.back() + static_cast<float>(random.uniform(0.0005, 0.05)));
      const long double o = outer.back();
      const long double n = inner.back();
      sum += o * o - n * n;
    }
    const double best = area_kernel(best_vectors()).squares(width, outer.data(), inner.data());
    EXPECT_LT(std::fabs(best / static_cast<double>(sum) - 1.0), 1e-14) << width;
    for (const Vectors kind : vectors_here())
      EXPECT_EQ(area_kernel(kind).squares(width, outer.data(), inner.data()), best)
          << name_of(kind) << ' ' << width;
  }
}

}  // namespace
}  // namespace onggi::clay::row_area_test
