#include "engine/clay/clay_view.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace onggi::clay_view_test {
namespace {

ClayDef grid(int rows = 100, int sectors = 16) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  def.outer_radius = 0.05;
  def.inner_radius = 0.02;
  return def;
}

ClayView lump() {
  ClayView clay;
  clay.lay(grid());
  return clay;
}

void shape(ClayView& clay, int row, float outer, float inner) {
  const auto sectors = static_cast<std::size_t>(clay.sectors());
  clay.shape(row, std::vector<float>(sectors, outer), std::vector<float>(sectors, inner));
}

void tear(ClayView& clay, int row, bool torn) {
  clay.place(row, {(row + 0.5) * 0.002, 0.2, 0.01, 5, torn});
}

TEST(ClayView, ALumpIsSeenAsTheClayWouldLayIt) {
  const ClayView view = lump();
  const Clay clay = std::move(*Clay::create(grid()));
  const Profile seen = view.profile(), real = clay.profile();
  ASSERT_EQ(seen.points.size(), real.points.size());
  for (std::size_t n = 0; n < real.points.size(); ++n) {
    EXPECT_EQ(seen.points[n].height, real.points[n].height);
    EXPECT_EQ(seen.points[n].outer, real.points[n].outer);
    EXPECT_EQ(seen.points[n].inner, real.points[n].inner);
  }
  EXPECT_EQ(view.floor_rows(), clay.floor_rows());
  EXPECT_TRUE(validate(seen, "lump").has_value());
}

RC_GTEST_PROP(ClayViewProperty, ItsOutlineIsTheClaysToTheBitWhateverWasPressed, ()) {
  ClayDef def = grid(*rc::gen::inRange(8, 60), *rc::gen::inRange(16, 90));
  Clay clay = std::move(*Clay::create(def));
  for (int n = 0; n < 20; ++n) {
    const int j = *rc::gen::inRange(clay.floor_rows(), def.rows);
    for (float& r : clay.outer_mut(j)) r += 1e-6f * static_cast<float>(*rc::gen::inRange(0, 9999));
    clay.set_row_thickness(j, 1e-5 * *rc::gen::inRange(1, 500));
    clay.restack(j);
  }
  ClayView view;
  view.take(clay);
  const Profile seen = view.profile(), real = clay.profile();
  RC_ASSERT(seen.points.size() == real.points.size());
  for (std::size_t n = 0; n < real.points.size(); ++n) {
    RC_ASSERT(seen.points[n].height == real.points[n].height);
    RC_ASSERT(seen.points[n].outer == real.points[n].outer);
    RC_ASSERT(seen.points[n].inner == real.points[n].inner);
    RC_ASSERT(seen.out_of_round == real.out_of_round);
  }
}

TEST(ClayView, AChangedRowChangesTheOutlineAtItsHeightOnly) {
  ClayView clay = lump();
  shape(clay, 50, 0.04f, 0.03f);
  EXPECT_NEAR(clay.radius_at(0.101, WallSide::outside), 0.04, 1e-6);
  EXPECT_NEAR(clay.radius_at(0.101, WallSide::inside), 0.03, 1e-6);
  EXPECT_NEAR(clay.radius_at(0.15, WallSide::outside), 0.05, 1e-8);
}

TEST(ClayView, RowsAreWhereTheySayTheyAre) {
  ClayView clay = lump();
  shape(clay, 99, 0.04f, 0.03f);
  for (int j = 50; j < 100; ++j) clay.place(j, {0.1 + (j - 49.5) * 0.001, 0.15, 0.008, 4, false});
  EXPECT_DOUBLE_EQ(clay.rim_height(), 0.15);
  EXPECT_DOUBLE_EQ(clay.floor_top(), 0.008);
  EXPECT_DOUBLE_EQ(clay.profile().height(), 0.15);
  EXPECT_NEAR(clay.radius_at(0.1495, WallSide::outside), 0.04, 1e-6);
  EXPECT_NEAR(clay.radius_at(0.1490, WallSide::outside), 0.045, 1e-6);
  EXPECT_NEAR(clay.radius_at(0.1480, WallSide::outside), 0.05, 1e-8);
  EXPECT_TRUE(validate(clay.profile(), "pressed").has_value());
}

TEST(ClayView, HeightsRiseWhileRowsAreOnTheirWay) {
  ClayView clay = lump();
  clay.place(90, {0.12, 0.15, 0.01, 5, false});  // those under it still say that they are higher
  EXPECT_TRUE(validate(clay.profile(), "on the way").has_value());
  EXPECT_DOUBLE_EQ(clay.profile().height(), 0.15);
}

TEST(ClayView, TheTornWallIsTheThinnestOfTheTornRows) {
  ClayView clay = lump();
  shape(clay, 50, 0.04f, 0.038f);
  EXPECT_FALSE(clay.torn_wall());
  tear(clay, 70, true);
  EXPECT_NEAR(clay.torn_wall().value(), 0.03, 1e-6);
  tear(clay, 50, true);
  EXPECT_NEAR(clay.torn_wall().value(), 0.002, 1e-6);
  tear(clay, 50, false);
  EXPECT_NEAR(clay.torn_wall().value(), 0.03, 1e-6);
  tear(clay, 100, true);  // of another grid
  clay.lay(grid());
  EXPECT_FALSE(clay.torn_wall());
}

TEST(ClayView, ARowOfAnotherGridIsRefused) {
  ClayView clay;
  clay.lay(grid(10));
  clay.shape(3, std::vector<float>(10, 0.01f), std::vector<float>(10, 0.005f));
  shape(clay, 10, 0.01f, 0.005f);
  EXPECT_NEAR(clay.radius_at(0.1, WallSide::outside), 0.05, 1e-8);
}

TEST(ClayView, WhoHasSeenItKnowsWhichRowsAreNew) {
  ClayView clay = lump();
  const std::uint64_t seen = clay.change();
  shape(clay, 7, 0.04f, 0.03f);
  tear(clay, 9, true);
  for (int j = 0; j < clay.rows(); ++j) {
    EXPECT_EQ(clay.shaped_at(j) > seen, j == 7) << j;
    EXPECT_EQ(clay.placed_at(j) > seen, j == 9) << j;
  }
  clay.lay(grid());
  for (int j = 0; j < clay.rows(); ++j) EXPECT_GT(clay.shaped_at(j), seen + 2);
}

}  // namespace
}  // namespace onggi::clay_view_test
