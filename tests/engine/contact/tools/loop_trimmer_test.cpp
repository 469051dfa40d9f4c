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

TEST(LoopTrimmer, PressesAsARayMarchThroughADiscSays) {
  agrees_with_a_ray_march("loop_trimmer", from_disc);
}
TEST(LoopTrimmer, GivesTheSameBitsOnAllVectors) { same_bits_on_all_vectors("loop_trimmer"); }
TEST(LoopTrimmer, HeldUprightLeavesASymmetricMark) {
  symmetric_pose_leaves_symmetric_mark("loop_trimmer");
}
TEST(LoopTrimmer, StaysFiniteAndWithinTheClaysLimitsInAnyPose) {
  random_poses_stay_within_limits("loop_trimmer");
}
TEST(LoopTrimmer, ItsBallReachesAsFarAsItDoes) {
  ball_reaches_as_far_as_the_body("loop_trimmer", from_disc);
}
TEST(LoopTrimmer, LooksWhereItTouches) { looks_where_it_touches("loop_trimmer"); }
TEST(LoopTrimmer, FeelsTheSameOnAnyGrid) {
  force_does_not_depend_on_the_grid("loop_trimmer", 0.05);
}

// What a firm tool presses for ten relaxation times, a blade has through at once, and with less
// force.
TEST(LoopTrimmer, GivesTheClayLessTimeThanARib) {
  EXPECT_LT(find_tool_shape("loop_trimmer")->relaxation, 0.5);
  EXPECT_TRUE(find_tool_shape("loop_trimmer")->cuts);
  EXPECT_FALSE(find_tool_shape("curved_rib")->cuts);
}

}  // namespace
}  // namespace onggi
