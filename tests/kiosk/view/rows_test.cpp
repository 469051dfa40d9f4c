#include "kiosk/view/rows.h"

#include <gtest/gtest.h>

namespace onggi::view {
namespace {

TEST(RowsOf, EveryRowCarriesTheProfileAtItsMiddle) {
  Profile bowl;
  bowl.points = {{0.0, 0.03, 0.0}, {0.01, 0.04, 0.03}, {0.1, 0.08, 0.07}};
  const GridShape shape{50, 16, 0.1, 0.01};
  const auto rows = rows_of(bowl, shape);
  ASSERT_EQ(rows.size(), 50u);
  for (const RowUpdate& row : rows) {
    const double h = (row.row + 0.5) * 0.002;
    ASSERT_EQ(row.radii.size(), 32u);
    EXPECT_FLOAT_EQ(row.radii[3], static_cast<float>(bowl.outer_at(h)));
    EXPECT_FLOAT_EQ(row.radii[16 + 3], h < 0.01 ? 0.0f : static_cast<float>(bowl.inner_at(h)));
  }
}

}  // namespace
}  // namespace onggi::view
