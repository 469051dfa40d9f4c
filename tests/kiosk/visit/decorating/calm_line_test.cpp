#include "kiosk/visit/decorating/calm_line.h"

#include <gtest/gtest.h>

namespace onggi::decorating {
namespace {

TEST(CalmLine, AFingerThatShakesWithinTheStringMovesNothing) {
  const surface::HandPlace tip{0.05, 0.5};
  const CalmPart part = calm_part(tip, tip, 0.0512, 0.0, 0.06);
  EXPECT_TRUE(part.way.empty());
  EXPECT_EQ(part.tip.along, tip.along);
}

TEST(CalmLine, ItsWayIsSmoothThroughTheMiddles) {
  const CalmPart first = calm_part({0.05, 0.5}, {0.05, 0.5}, 0.0715, 0.0, 0.06);
  EXPECT_NEAR(first.tip.along, 0.07, 1e-12);
  EXPECT_NEAR(first.way.back().along, 0.06, 1e-12);
  const CalmPart then = calm_part(first.way.back(), first.tip, 0.0715, 0.1, 0.06);
  // It leaves in the direction in which it came, and ends in that of the new part.
  const auto& begin = then.way.front();
  EXPECT_NEAR(begin.turns, 0.5, 0.002);
  EXPECT_GT(begin.along, first.way.back().along);
  EXPECT_NEAR(then.way.back().turns, 0.5 * (first.tip.turns + then.tip.turns), 1e-12);
  for (std::size_t n = 1; n < then.way.size(); ++n) {
    EXPECT_GE(then.way[n].turns, then.way[n - 1].turns);
    EXPECT_LE(then.way[n].along, 0.0715);
  }
}

}  // namespace
}  // namespace onggi::decorating
