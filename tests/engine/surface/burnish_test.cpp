#include "engine/surface/burnish.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::burnish_test {
namespace {

TEST(Burnish, ThreePassesPolishAndAFourthAddsNothing) {
  Surface surface = made(bowl());
  for (int pass = 1; pass <= 4; ++pass) {
    done(surface, BurnishDef{}, straight(surface, {0.015, 0.0}, {0.030, 0.0}));
    for (int i = -10; i < 10; ++i)
      ASSERT_EQ(surface.burnish(90, wrapped(i)), std::min(pass, 3)) << pass << ' ' << i;
  }
  EXPECT_EQ(surface.burnish(90, 40), 0);
  EXPECT_DOUBLE_EQ(roughness(0), 0.7);
  EXPECT_DOUBLE_EQ(roughness(3), 0.25);
}

TEST(Burnish, SlipAndScrapesTakeThePolishAway) {
  Surface surface = made(bowl());
  const auto way = straight(surface, {0.015, 0.0}, {0.030, 0.0});
  done(surface, BurnishDef{}, way);
  done(surface, BrushDef{}, straight(surface, {0.015, 0.0}, {0.020, 0.0}));
  EXPECT_EQ(surface.burnish(70, 0), 0);
  EXPECT_EQ(surface.burnish(100, 0), 1);
  done(surface, ScrapeDef{}, way);
  EXPECT_EQ(surface.burnish(100, 0), 0);
}

TEST(Burnish, GlazeIsNotPolished) {
  Surface surface = made(bowl());
  done(surface, whole_dip());
  done(surface, BurnishDef{}, straight(surface, {0.015, 0.0}, {0.030, 0.0}));
  EXPECT_EQ(surface.burnish(90, 0), 0);
}

}  // namespace
}  // namespace onggi::surface_test::burnish_test
