#include "engine/contact/bodies/box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/bodies/checks.h"

namespace onggi::box_test {
namespace {

using namespace body_checks;

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

TEST(FlatRib, UprightItIsCutAlikeAtEveryHeightAndWorkedOutOnce) {
  const ToolShape& rib = *find_tool_shape("flat_rib");
  const auto box = [&](Vec3 handle) {
    const ToolPlace at = hold_tool(rib, {0.05, 0.1, 0.02}, handle, 0.3, false);
    return body::Box{
        at.at, {at.along, at.across, cross(at.along, at.across)}, {0.045, 0.0015, 0.02}};
  };
  const body::Box upright = box({});
  ASSERT_TRUE(upright.upright());
  EXPECT_FALSE(box({0.01, 1.0, 0.0}).upright());
  const auto same = [](const body::SlabSection& a, const body::SlabSection& b) {
    return a.nx == b.nx && a.ny == b.ny && a.nz == b.nz && a.half == b.half && a.off == b.off &&
           a.asked == b.asked;
  };
  const body::Box::Section first = upright.section(0.1);
  for (const double y : {0.0551, 0.0873, 0.1, 0.1449, 0.144999999}) {
    EXPECT_EQ(upright.outline(y), upright.outline(0.1)) << y;
    const body::Box::Section there = upright.section(y);
    const body::Box::Section like = upright.section_like(first, y);
    EXPECT_TRUE(same(there.a, like.a) && same(there.b, like.b) && same(there.c, like.c)) << y;
    EXPECT_EQ(there.a.asked, y > 0.14499) << y;  // so near its end a ray might leave by it
    EXPECT_TRUE(there.b.asked && there.c.asked);
  }
}

}  // namespace
}  // namespace onggi::box_test
