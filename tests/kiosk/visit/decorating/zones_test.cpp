#include "kiosk/visit/decorating/zones.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kiosk/visit/decorating/decorated_pot.h"
#include "tests/kiosk/visit/decorating/every_tool.h"

namespace onggi::decorating::zones_test {
namespace {

/// A bottle: a straight body of 60 mm, a shoulder, a neck of 50 mm. Millimetres along its outside:
/// 60, and about 100.
Profile a_bottle() {
  Profile profile;
  for (int n = 0; n <= 130; ++n) {
    const double high = 0.001 * n;
    const double outer = n < 60 ? 0.06 : n < 80 ? 0.06 - 0.0017 * (n - 60) : 0.026;
    profile.points.push_back({high, outer, n < 6 ? 0.0 : outer - 0.005});
  }
  return profile;
}

struct OnABottle : testing::Test {
  decoration::Way way = every_tool();
  std::unique_ptr<DecoratedPot> pot = *DecoratedPot::begin(a_bottle(), way);
  bool painted(double along) const {
    return pot->surface().slip(static_cast<int>(along * 4000), 300).word() != 0;
  }
};

TEST_F(OnABottle, TheOutlinesTurnsPartItsZones) {
  const auto& borders = pot->zones().borders();
  ASSERT_EQ(borders.size(), 2u);
  EXPECT_NEAR(borders[0], 0.060, 0.003);
  EXPECT_NEAR(borders[1], 0.0994, 0.003);
}

TEST_F(OnABottle, ARingNearABorderKeepsToItsZone) {
  const double border = pot->zones().borders()[0];
  pot->choose_tool(band);
  pot->put({border - 0.001, 0.2});
  pot->finish();
  EXPECT_TRUE(painted(border - 0.004));
  EXPECT_FALSE(painted(border + 0.001));
}

TEST_F(OnABottle, AFigureNearABorderKeepsToItsZoneAndAFreeLineMayCross) {
  const double border = pot->zones().borders()[0];
  way.tools[leaf].size = 0.02;
  pot->choose_tool(leaf);
  pot->press({border - 0.0075, 300.5 / surface::kSectors});
  pot->lift();
  EXPECT_TRUE(painted(border - 0.002));
  EXPECT_FALSE(painted(border + 0.001));
  // Far over it, the visitor means it.
  pot->press({border, 300.5 / surface::kSectors});
  pot->lift();
  EXPECT_TRUE(painted(border + 0.008));
  pot->choose_tool(cut);
  pot->press({border - 0.01, 300.5 / surface::kSectors});
  pot->move({border + 0.02, 300.5 / surface::kSectors});
  pot->lift();
  EXPECT_LT(pot->surface().relief(static_cast<int>(border * 4000), 300), -200);
}

TEST_F(OnABottle, ARingIsLevelThoughTheFingerWavers) {
  pot->choose_tool(band);
  pot->press({0.03, 0.0});
  for (int n = 1; n <= 100; ++n) pot->move({0.03 + 0.03 * std::sin(0.3 * n), 0.01 * n});
  pot->lift();
  pot->finish();
  const int row = static_cast<int>(0.03 * 4000);
  for (int i = 0; i < surface::kSectors; ++i) {
    ASSERT_NE(pot->surface().slip(row + 10, i).word(), 0u) << i;
    ASSERT_EQ(pot->surface().slip(row + 15, i).word(), 0u) << i;
  }
}

TEST(Zones, ASmoothJarIsOneZone) {
  const decoration::Way way = every_tool();
  const auto pot = *DecoratedPot::begin(a_jar(), way);
  EXPECT_TRUE(pot->zones().borders().empty());
  EXPECT_EQ(pot->zones().within(0.08, 0.01, 0.01), 0.08);
}

}  // namespace
}  // namespace onggi::decorating::zones_test
