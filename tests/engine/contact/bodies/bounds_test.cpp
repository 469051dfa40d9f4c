#include "engine/contact/bodies/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::body {
namespace {

TEST(Bounds, AnOutlineThatIsNothingButRoundingSpansWhatTheTouchSpans) {
  // The corner of a block, a float's last digits large: nothing by nothing is no direction.
  const Turn coarse{0.3, 0.01};
  for (const float size : {1e-9f, 4e-10f, 1e-12f, 1e-38f}) {
    Outline corner;
    corner.x = 0.05f;
    corner.z = 0.016f;
    corner.ux = size;
    for (const WallSide side : {WallSide::outside, WallSide::inside}) {
      const Turn turn = turn_of(corner, side, 0.05, coarse);
      EXPECT_EQ(turn.middle, coarse.middle) << size;
      EXPECT_EQ(turn.half, coarse.half) << size;
    }
  }
}

}  // namespace
}  // namespace onggi::body
