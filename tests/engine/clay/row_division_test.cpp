#include "engine/clay/row_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"
#include "engine/math/random.h"

namespace onggi::clay::row_division_test {
namespace {

constexpr int kSpareRows = 60;

// A wall whose faces are where `outer` and `wall` say at each height and angle.
template <class Outer>
Clay thrown(const Outer& outer, double wall = 0.006) {
  ClayDef def;
  def.rows = 60;
  def.sectors = 40;
  def.height = 0.06;
  Clay clay = std::move(*Clay::create(def, best_vectors(), kSpareRows));
  clay.keep_areas();
  for (int j = 0; j < clay.rows(); ++j) {
    for (std::size_t i = 0; i < 40; ++i) {
      const double angle = (static_cast<double>(i) + 0.5) * 2.0 * portable::kPi / 40.0;
      const double r = outer(clay.row_height(j), angle);
      clay.outer_mut(j)[i] = static_cast<float>(r);
      if (j >= clay.floor_rows()) clay.inner_mut(j)[i] = static_cast<float>(r - wall);
    }
    clay.areas()->set(j, clay.measured_area(j));
  }
  while (clay.areas()->take_changed(0) >= 0) {
  }
  return clay;
}
Clay bowl() {
  return thrown([](double h, double) { return 0.03 + 0.6 * h; });
}
// Finger marks 8 mm apart and 0.4 mm deep, as a screw.
Clay marked() {
  return thrown([](double h, double angle) {
    return 0.04 + 0.2 * h + 0.0004 * std::sin(2.0 * portable::kPi * h / 0.008 + angle);
  });
}
double volume_of(const Clay& clay, int j) { return clay.areas()->of(j) * clay.row_thickness(j); }

void divide(Clay& clay, int j) {
  divide_row(clay, j, volume_of(clay, j));
  while (clay.areas()->take_changed(0) >= 0) {
  }
}
void join(Clay& clay, int j) {
  join_rows(clay, j, volume_of(clay, j) + volume_of(clay, j + 1));
  while (clay.areas()->take_changed(0) >= 0) {
  }
}

// How far two outlines are apart at most, m.
double apart(const Profile& a, const Profile& b) {
  double most = std::fabs(a.height() - b.height());
  for (int n = 0; n <= 4000; ++n) {
    const double h = n / 4000.0 * std::min(a.height(), b.height());
    most = std::max({most, std::fabs(a.outer_at(h) - b.outer_at(h))});
    if (h > 0.012) most = std::max(most, std::fabs(a.inner_at(h) - b.inner_at(h)));
  }
  return most;
}

void expect_stacked(const Clay& clay) {
  double edge = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    ASSERT_GT(clay.row_thickness(j), 0.0) << j;
    ASSERT_NEAR(clay.row_height(j) - 0.5 * clay.row_thickness(j), edge, 1e-12) << j;
    edge += clay.row_thickness(j);
    ASSERT_EQ(clay.place_of(clay.stored(j)), j);
    ASSERT_GE(clay.outer_most(j), *std::ranges::max_element(clay.outer(j)));
    ASSERT_LE(clay.inner_least(j), *std::ranges::min_element(clay.inner(j)));
  }
  ASSERT_GE(clay.floor_top(), clay.row_height(clay.floor_rows() - 1));
  ASSERT_LE(clay.floor_top(), clay.row_height(clay.floor_rows()));
}

TEST(RowDivision, ADividedRowLiesOnTheOutlineThatItWasPartOf) {
  for (const Clay& whole : {bowl(), marked()}) {
    Clay clay = whole;
    // Of the lowest and the highest nobody knows how they lean.
    for (int j = clay.rows() - 2; j > 0; --j)
      if (j != clay.floor_rows() && j + 1 != clay.floor_rows() && may_divide(clay, j))
        divide(clay, j);
    EXPECT_GT(clay.rows(), 110);
    EXPECT_LT(apart(clay.profile(), whole.profile()), 0.05 * whole.first_thickness() / 2);
    EXPECT_NEAR(clay.volume() / whole.volume(), 1.0, 1e-9);
    EXPECT_NEAR(clay.rim_height(), whole.rim_height(), 1e-8);
    EXPECT_EQ(clay.spare_rows() + clay.rows(), clay.room());
    expect_stacked(clay);
  }
}

TEST(RowDivision, NoRadiusIsLargerOrSmallerThanOneThatWasThere) {
  Random random(5);
  const Clay rough = thrown([&](double, double) { return random.uniform(0.04, 0.05); }, 0.02);
  Clay clay = rough;
  for (int j = clay.rows() - 1; j >= clay.floor_rows(); --j)
    if (may_divide(clay, j)) divide(clay, j);
  for (int j = clay.rows() - 1; j >= 1; --j)
    if (may_join(clay, j - 1)) join(clay, j - 1);
  for (int j = 0; j < clay.rows(); ++j)
    for (std::size_t i = 0; i < 40; ++i) {
      ASSERT_GE(clay.outer(j)[i], 0.04f - 1e-8f);
      ASSERT_LE(clay.outer(j)[i], 0.05f + 1e-8f);
      if (j >= clay.floor_rows()) {
        ASSERT_GE(clay.outer(j)[i] - clay.inner(j)[i], 0.004f - 1e-8f) << j << ' ' << i;
      }
    }
  EXPECT_NEAR(clay.volume() / rough.volume(), 1.0, 1e-9);
}

TEST(RowDivision, RowsThatAreAlikeAreDividedAndJoinedToTheBit) {
  Clay clay = thrown([](double, double angle) { return 0.05 + 0.001 * std::sin(angle); });
  const float radius = clay.outer(40)[7];
  divide(clay, 40);
  EXPECT_EQ(clay.outer(40)[7], radius);
  EXPECT_EQ(clay.outer(41)[7], radius);
  EXPECT_NE(clay.stored(41), 41);
  join(clay, 40);
  EXPECT_EQ(clay.stored(41), 41);
  EXPECT_EQ(clay.outer(40)[7], radius);
  EXPECT_NEAR(clay.row_thickness(40), 0.001, 1e-15);
}

TEST(RowDivision, AJoinMovesTheOutlineByNoMoreThanItSaid) {
  for (const Clay& whole : {bowl(), marked()}) {
    double largest = 0.0;
    for (int j = 0; j + 1 < whole.rows(); ++j) {
      if (!may_join(whole, j)) continue;
      Clay clay = whole;
      const double said = join_error(clay, j);
      join(clay, j);
      // Seen at the rows' middles, where the outlines have their corners.
      double is = 0.0;
      const Profile now = clay.profile();
      for (const int row : {j, j + 1}) {
        const double h = whole.row_height(row);
        is = std::max(is, std::fabs(now.outer_at(h) - whole.profile().outer_at(h)));
      }
      ASSERT_LE(is, said + 2e-6) << j;
      ASSERT_NEAR(clay.volume() / whole.volume(), 1.0, 1e-9) << j;
      largest = std::max(largest, said);
      ASSERT_NO_FATAL_FAILURE(expect_stacked(clay)) << j;
    }
    EXPECT_GT(largest, 1e-6);
    EXPECT_LT(largest, 0.31 * whole.first_thickness());
  }
}

TEST(RowDivision, ALineOneRowWideIsNoPairToBeJoined) {
  Clay clay = bowl();
  EXPECT_LT(join_error(clay, 40), 0.05 * clay.row_thickness(40));
  for (float& r : clay.outer_mut(41)) r -= 0.0005f;
  EXPECT_GT(join_error(clay, 40), 0.2 * clay.row_thickness(40));
}

TEST(RowDivision, RowsBesideTheFloorAreLetBeWhereItsTopWouldNotLieBetweenThem) {
  Clay clay = bowl();
  for (const double share : {0.01, 0.3, 0.49, 0.51, 0.7, 1.0}) {
    const int floor = clay.floor_rows();
    clay.set_floor(floor, clay.row_height(floor - 1) +
                              share * (clay.row_height(floor) - clay.row_height(floor - 1)));
    for (const int j : {floor - 1, floor}) {
      Clay one = clay;
      if (may_divide(one, j)) divide(one, j);
      ASSERT_NO_FATAL_FAILURE(expect_stacked(one)) << share << ' ' << j;
      EXPECT_EQ(one.floor_top(), clay.floor_top());
    }
    EXPECT_FALSE(may_join(clay, floor - 1)) << "one is solid";
  }
}

// Rows divided, joined and pressed at random, in strokes that are all taken back.
TEST(RowDivision, TheFloorsTopIsTheRimWhereEveryRowIsSolidHoweverManyThereAre) {
  ClayDef def;
  def.rows = 60;
  def.sectors = 40;
  def.floor_thickness = def.height;
  Clay clay = std::move(*Clay::create(def, best_vectors(), kSpareRows));
  clay.keep_areas();
  for (const int j : {20, 40}) divide(clay, j);
  ASSERT_EQ(clay.floor_rows(), 62);
  clay.set_floor(62, 0.05);
  EXPECT_EQ(clay.floor_top(), clay.rim_height());
  const double middle = clay.row_height(60) - 0.2 * clay.row_thickness(60);
  clay.set_floor(60, middle);
  EXPECT_EQ(clay.floor_top(), middle);
}

TEST(RowDivision, WhatARowTradedStaysWithItWhereRowsComeAndGoBelow) {
  Clay clay = bowl();
  RowAreas& areas = *clay.areas();
  areas.lose(30, 0.2 * areas.of(30));
  areas.lose(30, -0.2 * areas.of(30));
  ASSERT_TRUE(areas.drifted(30));
  divide(clay, 20);
  EXPECT_FALSE(areas.drifted(30));
  EXPECT_TRUE(areas.drifted(31));
  join(clay, 20);
  EXPECT_TRUE(areas.drifted(30));
  EXPECT_FALSE(areas.drifted(31));
}

TEST(RowDivision, HistoryGivesBackEveryStrokeToTheBit) {
  Clay clay = marked();
  History history(clay);
  Random random(8);
  const auto shape = [&] {
    std::vector<double> all;
    for (int j = 0; j < clay.rows(); ++j) {
      all.insert(all.end(), clay.outer(j).begin(), clay.outer(j).end());
      all.insert(all.end(), clay.inner(j).begin(), clay.inner(j).end());
      all.push_back(clay.row_thickness(j));
      all.push_back(clay.stored(j));
    }
    all.push_back(clay.floor_top());
    return all;
  };
  const auto some_row = [&](int from) {
    return from + static_cast<int>(random.uniform(0.0, clay.rows() - 1.0 - from));
  };
  std::vector<std::vector<double>> shapes;
  int divided = 0, joined = 0;
  for (int stroke = 0; stroke < 12; ++stroke) {
    shapes.push_back(shape());
    for (int n = 0; n < 60; ++n) {
      const int pressed = some_row(20);
      for (float& r : clay.outer_mut(pressed)) r -= 1e-5f;
      clay.areas()->set(pressed, clay.measured_area(pressed));
      clay.mark_dirty(pressed);
      while (clay.areas()->take_changed(0) >= 0) {
      }
      const int j = some_row(0);
      if (n % 2 == 0 && may_divide(clay, j)) {
        history.keep_row(clay, clay.stored(j));
        history.keep_row(clay, clay.next_spare());
        history.note_inserted(j + 1);
        divide(clay, j);
        ++divided;
      } else if (n % 2 == 1 && may_join(clay, j)) {
        history.keep_row(clay, clay.stored(j));
        history.keep_row(clay, clay.stored(j + 1));
        history.note_erased(j + 1, j < clay.floor_rows());
        join(clay, j);
        ++joined;
      }
      history.follow(clay, History::Stir::touching, 0.001);
    }
    // Not all strokes are long over when the next begins.
    for (int n = 0; n < (stroke % 2 == 0 ? 410 : 1000); ++n)
      history.follow(clay, History::Stir::none, 0.001);
  }
  EXPECT_GT(divided, 200);
  EXPECT_GT(joined, 100);
  for (; !shapes.empty(); shapes.pop_back()) {
    ASSERT_TRUE(history.can_step_back());
    int calls = 0;
    while (!history.step_back_some(clay, 2048)) ASSERT_LT(++calls, 10000);
    ASSERT_EQ(shape(), shapes.back()) << shapes.size();
    ASSERT_NO_FATAL_FAILURE(expect_stacked(clay));
  }
}

}  // namespace
}  // namespace onggi::clay::row_division_test
