#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/tools/checks.h"

namespace onggi {
namespace {

using namespace tool_checks;

// From a flat cylinder: beyond its faces, and beyond its round edge.
double from_disc(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double through = dot(q, place.across);
  const double x = std::fabs(through) - 0.5 * size.thickness;
  const double y = length(q - through * place.across) - size.radius;
  return length(Vec2{std::max(x, 0.0), std::max(y, 0.0)}) + std::min(std::max(x, y), 0.0);
}

TEST(CurvedRib, PressesAsARayMarchThroughADiscSays) {
  agrees_with_a_ray_march("curved_rib", from_disc);
}
TEST(CurvedRib, GivesTheSameBitsOnAllVectors) { same_bits_on_all_vectors("curved_rib"); }
TEST(CurvedRib, HeldUprightLeavesASymmetricMark) {
  symmetric_pose_leaves_symmetric_mark("curved_rib");
}
TEST(CurvedRib, StaysFiniteAndWithinTheClaysLimitsInAnyPose) {
  random_poses_stay_within_limits("curved_rib");
}
TEST(CurvedRib, ItsBallReachesAsFarAsItDoes) {
  ball_reaches_as_far_as_the_body("curved_rib", from_disc);
}
TEST(CurvedRib, LooksWhereItTouches) { looks_where_it_touches("curved_rib"); }
TEST(CurvedRib, FeelsTheSameOnAnyGrid) { force_does_not_depend_on_the_grid("curved_rib", 0.05); }

// A pot turned under it takes its curve, as a circle of its radius.
TEST(CurvedRib, ShapesTheWallToItsOwnCurve) {
  const ToolShape& rib = *find_tool_shape("curved_rib");
  Clay clay = std::move(*Clay::create({}));
  const ToolPlace at = pressing(rib, rib.usual, 0.055, 0.003, 0.1, 0.0);
  for (int n = 0; n < 12000; ++n) {
    const double turned = 0.0031 * n;
    const double c = std::cos(turned);
    const double s = std::sin(turned);
    const ToolPlace place{{c * at.at.x, at.at.y, s * at.at.x}, {0, 1, 0}, {-s, 0, c}};
    rib.press(clay, WallSide::outside, place, rib.usual, 0.001, {0.00949, 5e6});
  }
  for (int j = clay.first_row_above(0.09); clay.row_height(j) < 0.11; ++j) {
    const double up = clay.row_height(j) - 0.1;
    const double curve = at.at.x - std::sqrt(0.04 * 0.04 - up * up);
    for (std::size_t i = 0; i < 360; i += 17)
      ASSERT_NEAR(clay.outer(j)[i], curve, 5e-5) << j << ' ' << i;
  }
}

}  // namespace
}  // namespace onggi
