#include "engine/clay/clay.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "engine/math/portable.h"

namespace onggi::clay_test {
namespace {

Clay lump(const ClayDef& def = {}) {
  Result<Clay> clay = Clay::create(def);
  EXPECT_TRUE(clay) << to_text(clay.error());
  return std::move(*clay);
}

std::vector<int> dirty_rows(Clay& clay) {
  std::vector<int> rows;
  for (int j = clay.take_dirty(); j >= 0; j = clay.take_dirty(j + 1)) rows.push_back(j);
  return rows;
}

TEST(Clay, AFreshLumpIsAThickWalledCylinderWithAFloor) {
  const Clay clay = lump();
  EXPECT_EQ(clay.floor_rows(), 20);  // 10 mm of 0.5 mm rows
  for (int j : {0, 19, 20, 399}) {
    for (float r : clay.outer(j)) EXPECT_EQ(r, 0.055f);
    for (float r : clay.inner(j)) EXPECT_EQ(r, j < 20 ? 0.0f : 0.022f);
  }
  EXPECT_NEAR(clay.rim_height(), 0.20, 1e-12);
  const double expected =
      portable::kPi * (0.055 * 0.055 * 0.2 - 0.022 * 0.022 * (0.2 - 20 * 0.0005));
  EXPECT_NEAR(clay.volume() / expected, 1.0, 1e-6);
}

TEST(Clay, ItsProfileStandsOnTheWheelHeadAndEndsAtTheRim) {
  const Profile p = lump().profile();
  EXPECT_TRUE(validate(p, "lump"));
  EXPECT_EQ(p.points.front().height, 0.0);
  EXPECT_NEAR(p.height(), 0.2, 1e-12);
  EXPECT_NEAR(p.outer_at(0.1), 0.055, 1e-7);
  EXPECT_NEAR(p.inner_at(0.1), 0.022, 1e-7);
  EXPECT_EQ(p.inner_at(0.0), 0.0);
}

// The root mean square of a sine is its height over the root of two.
TEST(Clay, ItsProfileTellsHowFarItIsOutOfRoundOverAllHeights) {
  Clay clay = lump();
  EXPECT_EQ(clay.profile().out_of_round, 0.0);
  for (int j = 0; j < clay.rows(); j += 2)
    for (std::size_t i = 0; i < clay.outer_mut(j).size(); ++i)
      clay.outer_mut(j)[i] += static_cast<float>(
          0.002 * std::sin(2.0 * portable::kPi * static_cast<double>(i) / 120.0));
  EXPECT_NEAR(clay.profile().out_of_round, 0.001, 1e-7) << "half of the rows";
  EXPECT_NEAR(scaled(clay.profile(), 3.0).out_of_round, 0.003, 3e-7);
  EXPECT_EQ(resampled(clay.profile(), 9).out_of_round, clay.profile().out_of_round);
}

RC_GTEST_PROP(ClayProperty, TheFirstRowAboveAHeightIsTheLowestWhoseMiddleLiesAboveIt, ()) {
  ClayDef def;
  def.rows = *rc::gen::inRange(8, 300);
  def.sectors = 16;
  const Clay clay = lump(def);
  const double h = *rc::gen::inRange(-100, 400) * 0.001;
  const int j = clay.first_row_above(h);
  if (j < clay.rows()) RC_ASSERT(clay.row_height(j) > h);
  if (j > 0) RC_ASSERT(clay.row_height(j - 1) <= h);
}

RC_GTEST_PROP(ClayProperty, EveryDirtyRowIsTakenOnceInOrder, ()) {
  ClayDef def;
  def.sectors = 16;
  def.rows = *rc::gen::inRange(8, 200);
  Clay clay = lump(def);
  RC_ASSERT(static_cast<int>(dirty_rows(clay).size()) == def.rows);  // a fresh lump is all new
  const auto marked = *rc::gen::container<std::set<int>>(rc::gen::inRange(0, def.rows));
  for (int j : marked) clay.mark_dirty(j);
  RC_ASSERT(dirty_rows(clay) == std::vector<int>(marked.begin(), marked.end()));
  RC_ASSERT(clay.take_dirty() == -1);
}

TEST(Clay, RenewIsSpreadOverCallsAndAsGoodAsNew) {
  Clay clay = lump();
  const std::uint64_t fresh = clay.hash();
  clay.outer_mut(100)[7] = 0.05f;
  clay.inner_mut(30)[359] = 0.03f;
  clay.set_row_thickness(399, 0.0002);
  clay.restack(399);
  clay.open_floor_row(0.008);
  clay.lower_floor(0.0096);
  dirty_rows(clay);
  EXPECT_NE(clay.hash(), fresh);

  int calls = 1;
  while (!clay.renew_some(8192)) ++calls;
  EXPECT_EQ(calls, 19);  // 400 rows, 22 a call
  EXPECT_EQ(dirty_rows(clay).size(), 400u);
  EXPECT_EQ(clay.hash(), fresh);
}

TEST(Clay, ARowThatOnlyMovesUpOrDownIsToBeDrawnAndIsNotChanged) {
  Clay clay = lump();
  dirty_rows(clay);
  while (clay.take_change() >= 0) {
  }
  clay.set_row_thickness(390, 0.0003);
  clay.restack(390);
  EXPECT_TRUE(dirty_rows(clay).empty()) << "its radii are what they were";
  for (int j = 390; j < 400; ++j) EXPECT_EQ(clay.take_moved(), j);
  EXPECT_EQ(clay.take_moved(), -1);
  EXPECT_EQ(clay.take_change(), 390);
  EXPECT_EQ(clay.take_change(), -1);
}

TEST(Clay, SectorsThatAreNoMultipleOfEightArePadded) {
  ClayDef def;
  def.sectors = 100;
  Clay clay = lump(def);
  EXPECT_EQ(clay.stride(), 104);
  EXPECT_EQ(clay.outer(0).size(), 100u);
  // No tool touches the padding: it lies nowhere that a ray of (0, 0) could meet.
  EXPECT_EQ(clay.ray_cos()[103], 0.0f);
  EXPECT_LT(clay.outer(0).data()[103], -1.0f);
  EXPECT_GT(clay.inner(0).data()[103], 1.0f);
}

TEST(Clay, ARowsExtentHoldsTheRowWhateverIsWritten) {
  Clay clay = lump();
  EXPECT_EQ(clay.outer_most(200), 0.055f);
  EXPECT_EQ(clay.inner_least(200), 0.022f);
  clay.outer_mut(200)[7] = 0.1f;
  clay.inner_mut(201)[7] = 0.01f;
  EXPECT_GE(clay.outer_most(200), 0.1f);
  EXPECT_LE(clay.inner_least(201), 0.01f);
  clay.set_extent(200, 0.1f, 0.022f);
  clay.widen_extent(200, 0.05f, 0.02f);
  EXPECT_EQ(clay.outer_most(200), 0.1f);
  EXPECT_EQ(clay.inner_least(200), 0.02f);
}

TEST(ClayDef, EveryFieldOutOfRangeIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto field = [](auto change) {
    ClayDef def;
    change(def);
    const Result<void> result = validate(def, "clay");
    EXPECT_FALSE(result);
    EXPECT_FALSE(Clay::create(def));
    return result ? std::string() : result.error().where;
  };
  EXPECT_EQ(field([](ClayDef& d) { d.rows = 7; }), "clay.rows");
  EXPECT_EQ(field([](ClayDef& d) { d.rows = 20001; }), "clay.rows");
  EXPECT_EQ(field([](ClayDef& d) { d.sectors = 15; }), "clay.sectors");
  EXPECT_EQ(field([](ClayDef& d) { d.rows = 20000, d.sectors = 8192; }), "clay.rows");
  EXPECT_EQ(field([&](ClayDef& d) { d.height = nan; }), "clay.height");
  EXPECT_EQ(field([](ClayDef& d) { d.radius_max = 2; }), "clay.radius_max");
  EXPECT_EQ(field([](ClayDef& d) { d.radius_min = 0; }), "clay.radius_min");
  EXPECT_EQ(field([](ClayDef& d) { d.wall_min = 0; }), "clay.wall_min");
  EXPECT_EQ(field([](ClayDef& d) { d.inner_radius = 0.001; }), "clay.inner_radius");
  EXPECT_EQ(field([](ClayDef& d) { d.outer_radius = 0.025; }), "clay.outer_radius");
  EXPECT_EQ(field([](ClayDef& d) { d.outer_radius = 0.16; }), "clay.outer_radius");
  EXPECT_EQ(field([](ClayDef& d) { d.floor_thickness = 0.21; }), "clay.floor_thickness");
  EXPECT_EQ(field([](ClayDef& d) { d.floor_min = 0; }), "clay.floor_min");
}

TEST(Clay, AFloorThatIsPutBackStaysWithinTheRowsThatThereAreNow) {
  ClayDef def;
  def.floor_thickness = def.height;
  Clay solid = std::move(*Clay::create(def));
  const double was = solid.floor_top();
  solid.set_row_thickness(399, 0.0004);
  solid.restack(399);
  solid.set_floor(400, was);  // as it stood before the rim was pressed
  EXPECT_EQ(solid.floor_top(), solid.rim_height());
  Clay open = std::move(*Clay::create({}));
  open.set_floor(20, 0.5);
  EXPECT_EQ(open.floor_top(), open.row_height(20));
  open.set_floor(20, 0.0);
  EXPECT_EQ(open.floor_top(), open.row_height(19));
}

}  // namespace
}  // namespace onggi::clay_test
