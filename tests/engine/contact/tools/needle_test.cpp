#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/tools/checks.h"

namespace onggi {
namespace {

using namespace tool_checks;

double from_needle(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double on = std::clamp(dot(q, place.along), 0.0, size.length);
  return length(q - on * place.along) - size.radius;
}

TEST(Needle, PressesAsARayMarchThroughItSays) { agrees_with_a_ray_march("needle", from_needle); }
TEST(Needle, GivesTheSameBitsOnAllVectors) { same_bits_on_all_vectors("needle"); }
TEST(Needle, HeldLevelLeavesASymmetricMark) { symmetric_pose_leaves_symmetric_mark("needle"); }
TEST(Needle, StaysFiniteAndWithinTheClaysLimitsInAnyPose) {
  random_poses_stay_within_limits("needle");
}
TEST(Needle, ItsBallReachesAsFarAsItDoes) {
  ball_reaches_as_far_as_the_body("needle", from_needle);
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

}  // namespace
}  // namespace onggi
