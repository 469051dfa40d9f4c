#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/tools/checks.h"

namespace onggi {
namespace {

using namespace tool_checks;

// From a block: what the point is beyond each pair of faces.
double from_plate(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double x = std::fabs(dot(q, place.along)) - 0.5 * size.length;
  const double y = std::fabs(dot(q, place.across)) - 0.5 * size.thickness;
  const double z = std::fabs(dot(q, cross(place.along, place.across))) - size.radius;
  const Vec3 out{std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0)};
  return length(out) + std::min(std::max({x, y, z}), 0.0);
}

TEST(FlatRib, PressesAsARayMarchThroughAPlateSays) {
  agrees_with_a_ray_march("flat_rib", from_plate);
}
TEST(FlatRib, GivesTheSameBitsOnAllVectors) { same_bits_on_all_vectors("flat_rib"); }
TEST(FlatRib, HeldFlatLeavesASymmetricMark) { symmetric_pose_leaves_symmetric_mark("flat_rib"); }
TEST(FlatRib, StaysFiniteAndWithinTheClaysLimitsInAnyPose) {
  random_poses_stay_within_limits("flat_rib");
}
TEST(FlatRib, ItsBallReachesAsFarAsItDoes) {
  ball_reaches_as_far_as_the_body("flat_rib", from_plate);
}
TEST(FlatRib, LooksWhereItTouches) { looks_where_it_touches("flat_rib"); }
TEST(FlatRib, FeelsTheSameOnAnyGrid) { force_does_not_depend_on_the_grid("flat_rib", 0.03); }

TEST(FlatRib, HeldToAStillWallMakesAFlatFacet) {
  const ToolShape& rib = *find_tool_shape("flat_rib");
  for (const int sectors : {360, 1440}) {
    ClayDef def;
    def.sectors = sectors;
    Clay clay = std::move(*Clay::create(def));
    const ToolPlace place = pressing(rib, rib.usual, 0.055, 0.002, 0.1, 0.7);
    for (int n = 0; n < 200; ++n)
      rib.press(clay, WallSide::outside, place, rib.usual, 0.001, {0.00949, 5e6});
    // How far the facet's points are from the plane 53 mm away, and how wide it is.
    const int j = clay.first_row_above(0.1);
    double worst = 0.0;
    double widest = 0.0;
    for (int i = 0; i < sectors; ++i) {
      const auto n = static_cast<std::size_t>(i);
      if (clay.outer(j)[n] > 0.05499f) continue;
      const double off =
          std::remainder((i + 0.5) * 2.0 * 3.14159265358979 / sectors - 0.7, 6.28318530717959);
      worst = std::max(worst, std::fabs(double{clay.outer(j)[n]} * std::cos(off) - 0.053));
      widest = std::max(widest, std::fabs(double{clay.outer(j)[n]} * std::sin(off)));
    }
    EXPECT_LT(worst, 2e-6) << sectors;
    EXPECT_NEAR(widest, std::sqrt(0.055 * 0.055 - 0.053 * 0.053), 0.001) << sectors;
  }
}

}  // namespace
}  // namespace onggi
