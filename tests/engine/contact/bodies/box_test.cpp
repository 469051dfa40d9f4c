#include "engine/contact/bodies/box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/bodies/checks.h"

namespace onggi {
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

}  // namespace
}  // namespace onggi
