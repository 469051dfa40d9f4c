#include "kiosk/lab/plots/error_pot.h"

#include <gtest/gtest.h>

namespace onggi::plots::error_pot_test {
namespace {

TEST(ErrorPot, APotIsAsHighAsAskedStandsOnNothingAndIsColouredByItsErrors) {
  PotFace pot{32, 40, 0.2, std::vector<float>(32 * 40, 0.05f), std::vector<float>(32 * 40, 1e-6f)};
  const view::Image good = paint_pot(pot, 100);
  EXPECT_EQ(good.height, 100);
  EXPECT_NEAR(good.width, 50, 4);  // 0.1 m wide, 0.2 m high
  EXPECT_EQ(good.rgba[3], 0);      // the paper beside it
  pot.off.assign(pot.off.size(), 1e-3f);
  const view::Image bad = paint_pot(pot, 100);
  const std::size_t middle = 4 * (50 * static_cast<std::size_t>(good.width) + 25);
  EXPECT_GT(good.rgba[middle + 1], good.rgba[middle]);    // celadon
  EXPECT_GT(bad.rgba[middle], 2 * bad.rgba[middle + 1]);  // iron
}

TEST(ErrorPot, TheScaleGoesByDecadesAndBack) {
  EXPECT_EQ(share_of_error(0.0), 0.0);
  EXPECT_EQ(share_of_error(1.0), 1.0);
  EXPECT_NEAR(share_of_error(1e-5), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(error_from_share(share_of_error(3e-5)), 3e-5, 1e-12);
}

}  // namespace
}  // namespace onggi::plots::error_pot_test
