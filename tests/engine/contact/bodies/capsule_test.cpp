#include "engine/contact/bodies/capsule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/bodies/checks.h"

namespace onggi::capsule_test {
namespace {

using namespace body_checks;

// The two kernels have nothing in common but the frame.
TEST(Fingertip, OfNoLengthIsABall) {
  const ToolShape& ball = *find_tool_shape("sphere");
  const ToolShape& finger = *find_tool_shape("fingertip");
  for (const WallSide side : {WallSide::outside, WallSide::inside}) {
    Clay one = std::move(*Clay::create({}));
    Clay other = one;
    const double away = side == WallSide::outside ? 0.0615 : 0.0155;
    const ToolPlace place{{away * 0.8, 0.1, away * 0.6}, {0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}};
    Press a, b;
    for (int n = 0; n < 20; ++n) {
      a = ball.press(one, side, place, {0.008, 0.0, 0.0}, 0.001, {0.00949, 5e6});
      b = finger.press(other, side, place, {0.008, 0.0, 0.0}, 0.001, {0.00949, 5e6});
    }
    // At the edge of a finger's print is looked where it ends between two elements, at a ball's
    // not.
    // And a finger feels p on its own surface, which adds up to a ball's law on an even face only.
    EXPECT_LT(length(a.force - b.force), 0.06 * a.normal);
    EXPECT_NEAR(a.normal, b.normal, 0.02 * a.normal);
    for (int j = 0; j < one.rows(); ++j)
      for (std::size_t i = 0; i < 360; ++i) {
        ASSERT_NEAR(one.outer(j)[i], other.outer(j)[i], 2e-7) << j << ' ' << i;
        ASSERT_NEAR(one.inner(j)[i], other.inner(j)[i], 2e-7) << j << ' ' << i;
      }
  }
}

TEST(Fingertip, LaidAlongTheWallPressesALongerMarkThanWithItsTip) {
  const ToolShape& finger = *find_tool_shape("fingertip");
  const auto height_of_mark = [&](Vec3 along) {
    Clay clay = std::move(*Clay::create({}));
    finger.press(clay, WallSide::outside, {{0.062, 0.1, 0.0}, along, {0, 0, 1}}, finger.usual,
                 0.001, {0.00949, 5e6});
    int rows = 0;
    for (int j = 0; j < clay.rows(); ++j) rows += clay.outer(j)[0] < 0.055f ? 1 : 0;
    return rows * 0.2 / clay.rows();
  };
  EXPECT_NEAR(height_of_mark({0, 1, 0}) - height_of_mark({1, 0, 0}), 0.022, 0.001);
}

// It is thinner than the elements: from whatever place it always finds one, and what is felt of it
// does not come and go.
TEST(Needle, ThinnerThanAnElementIsNeverLostAndNeverJumps) {
  const ToolShape& needle = *find_tool_shape("needle");
  ClayDef def;
  def.rows = 50;      // of 4 mm
  def.sectors = 100;  // of 3.5 mm
  double least = 1.0;
  double most = 0.0;
  double last = 0.0;
  for (int n = 0; n < 400; ++n) {
    Clay clay = std::move(*Clay::create(def));
    const double angle = 0.000371 * n;
    const Vec3 out{std::cos(angle), 0.0, std::sin(angle)};
    const ToolPlace place{0.0536 * out + Vec3{0.0, 0.1 + 0.000023 * n, 0.0}, out, {0, 1, 0}};
    const Press press =
        needle.press(clay, WallSide::outside, place, needle.usual, 0.001, {0.00949, 5e6});
    EXPECT_GE(press.touched, 1) << n;
    EXPECT_LE(press.touched, 4) << n;
    if (n > 0) {
      EXPECT_NEAR(press.normal / last, 1.0, 0.05) << n;
    }
    last = press.normal;
    least = std::min(least, press.normal);
    most = std::max(most, press.normal);
  }
  EXPECT_LT(most / least, 1.8);  // by how its round point lies in the elements' strips
}

// A stick that lies on clay and is tilted to and fro: where it is felt goes along with it, and is
// not at its one end now and at its other a hair later.
TEST(SupportEnd, GoesFromOneEndToTheOtherWithinATenthOfSquareAtAnEvenPace) {
  const auto end_at = [](double tilt) {
    return body::support_end({std::sqrt(1.0 - tilt * tilt), tilt, 0.0}, {0, 1, 0});
  };
  for (const double tilt : {-1.0, -0.5, -0.1}) {
    EXPECT_DOUBLE_EQ(end_at(tilt), -1.0) << tilt;
    EXPECT_DOUBLE_EQ(end_at(-tilt), 1.0) << tilt;
  }
  for (double tilt = -0.1; tilt <= 0.1; tilt += 0.01)
    EXPECT_NEAR(end_at(tilt), tilt / 0.1, 1e-12) << tilt;
}

}  // namespace
}  // namespace onggi::capsule_test
