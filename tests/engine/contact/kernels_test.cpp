#include "engine/contact/kernels.h"

#include <gtest/gtest.h>

#include <vector>

namespace onggi::contact::kernels_test {
namespace {

TEST(Extent, IsThatOfTheRowsOwnElementsAndNotOfItsNeighbours) {
  for (const Vectors kind : vectors_here())
    for (int stride = 8; stride <= 72; stride += 8)
      for (int farthest = 0; farthest < stride; ++farthest) {
        // The rows before and after reach farther, either way.
        std::vector<float> outer(3 * static_cast<std::size_t>(stride), 9.0f),
            inner(outer.size(), 0.0f);
        for (int i = 0; i < stride; ++i) {
          const auto at = static_cast<std::size_t>(stride + i);
          outer[at] = i == farthest ? 0.07f : 0.05f;
          inner[at] = i == farthest ? 0.02f : 0.04f;
        }
        const auto extent = kernels(kind).extent;
        ASSERT_EQ(extent(WallSide::outside, stride, outer.data() + stride), 0.07f)
            << name_of(kind) << ' ' << stride << ' ' << farthest;
        ASSERT_EQ(extent(WallSide::inside, stride, inner.data() + stride), 0.02f)
            << name_of(kind) << ' ' << stride << ' ' << farthest;
      }
}

}  // namespace
}  // namespace onggi::contact::kernels_test
