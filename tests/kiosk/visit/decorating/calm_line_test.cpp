#include "kiosk/visit/decorating/calm_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace onggi::decorating::calm_line_test {
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

// At five frames a second, and with a device that tells one place a frame, a circle drawn in a
// second has five points. It is smaller then, and still round.
TEST(CalmLine, AQuickCircleOfFewPointsIsRound) {
  const double turn = 6.283185307179586, radius = 0.06, circle = 0.02;
  const surface::HandPlace middle{0.1, 0.5};
  for (const int points : {4, 5, 6, 8, 60}) {
    surface::HandPlace drawn{middle.along + circle, middle.turns}, tip = drawn;
    std::vector<std::pair<double, double>> way;  // m, from the circle's middle
    for (int n = 1; n <= 2 * points; ++n) {
      const double at = turn * n / points;
      const double turns = middle.turns + circle * std::sin(at) / (turn * radius);
      const CalmPart part =
          calm_part(drawn, tip, middle.along + circle * std::cos(at), turns - tip.turns, radius);
      for (const surface::HandPlace& place : part.way)
        way.emplace_back(place.along - middle.along, (place.turns - middle.turns) * turn * radius);
      drawn = part.way.back();
      tip = part.tip;
    }
    double least = 1.0, most = 0.0;
    // The second time round: the first begins in the middle of a stroke.
    for (std::size_t n = way.size() / 2; n + 1 < way.size(); ++n) {
      const auto [x0, y0] = way[n - 1];
      const auto [x, y] = way[n];
      const auto [x1, y1] = way[n + 1];
      const double bend =
          std::remainder(std::atan2(y1 - y, x1 - x) - std::atan2(y - y0, x - x0), turn);
      EXPECT_LT(std::abs(bend), 0.14) << points << ": a corner of 8 degrees";
      least = std::min(least, std::hypot(x, y));
      most = std::max(most, std::hypot(x, y));
    }
    EXPECT_LT(most - least, 0.001) << points;
    EXPECT_GT(least, 0.65 * circle) << points;
  }
}

}  // namespace
}  // namespace onggi::decorating::calm_line_test
