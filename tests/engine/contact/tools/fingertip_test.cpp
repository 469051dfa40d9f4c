#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/tools/checks.h"

namespace onggi {
namespace {

using namespace tool_checks;

// From the nearest point of the finger's middle line.
double from_finger(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double on = std::clamp(dot(q, place.along), 0.0, size.length);
  return length(q - on * place.along) - size.radius;
}

TEST(Fingertip, PressesAsARayMarchThroughACapsuleSays) {
  agrees_with_a_ray_march("fingertip", from_finger);
}
TEST(Fingertip, GivesTheSameBitsOnAllVectors) { same_bits_on_all_vectors("fingertip"); }
TEST(Fingertip, HeldUprightLeavesASymmetricMark) {
  symmetric_pose_leaves_symmetric_mark("fingertip");
}
TEST(Fingertip, StaysFiniteAndWithinTheClaysLimitsInAnyPose) {
  random_poses_stay_within_limits("fingertip");
}
TEST(Fingertip, ItsBallReachesAsFarAsItDoes) {
  ball_reaches_as_far_as_the_body("fingertip", from_finger);
}
TEST(Fingertip, LooksWhereItTouches) { looks_where_it_touches("fingertip"); }
TEST(Fingertip, FeelsTheSameOnAnyGrid) { force_does_not_depend_on_the_grid("fingertip", 0.03); }

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
    EXPECT_LT(length(a.force - b.force), 1e-3 * a.normal);
    EXPECT_NEAR(a.normal, b.normal, 1e-3 * a.normal);
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

}  // namespace
}  // namespace onggi
