#include "kiosk/loop/mirror.h"

#include <gtest/gtest.h>

#include <vector>

namespace onggi::loop {
namespace {

TEST(Mirror, ALumpIsACylinderWithASolidFloor) {
  Mirror mirror;
  mirror.reset(100, 16, 0.2, 0.01, 0.05, 0.02);
  const Profile profile = mirror.profile();
  EXPECT_DOUBLE_EQ(profile.height(), 0.2);
  EXPECT_DOUBLE_EQ(profile.outer_at(0.1), 0.05);
  EXPECT_DOUBLE_EQ(profile.inner_at(0.1), 0.02);
  EXPECT_DOUBLE_EQ(profile.inner_at(0.004), 0.0);
  EXPECT_TRUE(validate(profile, "lump").has_value());
}

TEST(Mirror, AChangedRowChangesTheProfileAtItsHeightOnly) {
  Mirror mirror;
  mirror.reset(100, 16, 0.2, 0.01, 0.05, 0.02);
  std::vector<float> row(32, 0.04f);
  for (int i = 16; i < 32; ++i) row[static_cast<std::size_t>(i)] = 0.03f;
  mirror.apply(50, row);
  EXPECT_NEAR(mirror.radius_at(0.101, WallSide::outside), 0.04, 1e-6);
  EXPECT_NEAR(mirror.radius_at(0.101, WallSide::inside), 0.03, 1e-6);
  EXPECT_NEAR(mirror.radius_at(0.15, WallSide::outside), 0.05, 1e-12);
}

TEST(Mirror, RowsAreWhereTheySayTheyAre) {
  Mirror mirror;
  mirror.reset(100, 16, 0.2, 0.01, 0.05, 0.02);
  std::vector<float> row(32, 0.04f);
  for (int i = 16; i < 32; ++i) row[static_cast<std::size_t>(i)] = 0.03f;
  mirror.apply(99, row);
  for (int j = 50; j < 100; ++j) mirror.stack(j, 0.1 + (j - 49.5) * 0.001, 0.15, 0.008);
  EXPECT_DOUBLE_EQ(mirror.height(), 0.15);
  EXPECT_DOUBLE_EQ(mirror.floor_height(), 0.008);
  EXPECT_DOUBLE_EQ(mirror.profile().height(), 0.15);
  EXPECT_NEAR(mirror.radius_at(0.1495, WallSide::outside), 0.04, 1e-6);
  EXPECT_NEAR(mirror.radius_at(0.1490, WallSide::outside), 0.045, 1e-6);
  EXPECT_NEAR(mirror.radius_at(0.1480, WallSide::outside), 0.05, 1e-12);
  EXPECT_TRUE(validate(mirror.profile(), "pressed").has_value());
}

TEST(Mirror, HeightsRiseWhileRowsAreOnTheirWay) {
  Mirror mirror;
  mirror.reset(100, 16, 0.2, 0.01, 0.05, 0.02);
  mirror.stack(90, 0.12, 0.15, 0.01);  // those under it still say that they are higher
  EXPECT_TRUE(validate(mirror.profile(), "on the way").has_value());
  EXPECT_DOUBLE_EQ(mirror.profile().height(), 0.15);
}

TEST(Mirror, TheTornWallIsTheThinnestOfTheTornRows) {
  Mirror mirror;
  mirror.reset(100, 16, 0.2, 0.01, 0.05, 0.02);
  std::vector<float> row(32, 0.04f);
  for (std::size_t i = 16; i < 32; ++i) row[i] = 0.038f;
  mirror.apply(50, row);
  EXPECT_FALSE(mirror.torn_wall());
  mirror.tear(70, true);
  EXPECT_NEAR(mirror.torn_wall().value(), 0.03, 1e-6);
  mirror.tear(50, true);
  EXPECT_NEAR(mirror.torn_wall().value(), 0.002, 1e-6);
  mirror.tear(50, false);
  EXPECT_NEAR(mirror.torn_wall().value(), 0.03, 1e-6);
  mirror.tear(100, true);  // of another grid
  mirror.reset(100, 16, 0.2, 0.01, 0.05, 0.02);
  EXPECT_FALSE(mirror.torn_wall());
}

TEST(Mirror, ARowOfAnotherGridIsRefused) {
  Mirror mirror;
  mirror.reset(10, 16, 0.2, 0.01, 0.05, 0.02);
  mirror.apply(3, std::vector<float>(20, 0.01f));
  mirror.apply(10, std::vector<float>(32, 0.01f));
  EXPECT_DOUBLE_EQ(mirror.radius_at(0.1, WallSide::outside), 0.05);
}

}  // namespace
}  // namespace onggi::loop
