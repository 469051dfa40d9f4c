#include "engine/contact/bodies/cylinder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/contact/bodies/checks.h"

namespace onggi::cylinder_test {
namespace {

using namespace body_checks;

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

// A disc round the axis, a little off it, presses nearly all of a wall from inside: its window is
// the whole turn, and its print's ends lie anywhere in it.
TEST(CurvedRib, RoundTheAxisIsFeltAlikeWhereverItsPrintEndsInTheTurn) {
  const ToolShape& rib = *find_tool_shape("curved_rib");
  for (const int sectors : {64, 68}) {  // 68: the last block ends in padding
    ClayDef def;
    def.sectors = sectors;
    def.inner_radius = 0.03;
    double least = 1e9, most = 0.0;
    for (int k = 0; k < sectors; ++k) {
      Clay clay = std::move(*Clay::create(def));
      const double angle = 2.0 * 3.141592653589793 * (k + 0.3) / sectors;
      const double c = std::cos(angle), s = std::sin(angle);
      const ToolPlace place{{0.004 * c, 0.1, 0.004 * s}, {c, 0.0, s}, {0, 1, 0}};
      ToolSize size = rib.usual;
      size.radius = 0.0338;
      const double normal =
          rib.press(clay, WallSide::inside, place, size, 0.001, {0.00949, 5e6}).normal;
      least = std::min(least, normal);
      most = std::max(most, normal);
    }
    EXPECT_GT(least, 0.5) << sectors;
    EXPECT_LT(most / least - 1.0, 1e-5) << sectors;
  }
}

}  // namespace
}  // namespace onggi::cylinder_test
