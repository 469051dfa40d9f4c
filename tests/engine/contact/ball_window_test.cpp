#include "engine/contact/ball_window.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/contact/bodies/ball.h"
#include "engine/math/portable.h"
#include "tests/support/sphere.h"

namespace onggi::contact::ball_window_test {
namespace {

using body::cross_section;

Clay lump(int rows, int sectors) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  return std::move(*Clay::create(def));
}

// How deep the sphere at `at` presses the ray of (row, sector), by plain geometry in double.
double press_there(const Clay& clay, WallSide side, Vec3 at, double radius, int row, int sector) {
  const double angle = (sector + 0.5) * 2.0 * portable::kPi / clay.sectors();
  const double dy = at.y - clay.row_height(row);
  if (std::fabs(dy) >= radius) return 0.0;
  const double r = std::sqrt(radius * radius - dy * dy);
  const double along = at.x * std::cos(angle) + at.z * std::sin(angle);
  const double off = std::fabs(at.z * std::cos(angle) - at.x * std::sin(angle));
  if (off >= r) return 0.0;
  const double q = std::sqrt(r * r - off * off);
  const auto i = static_cast<std::size_t>(sector);
  if (side == WallSide::inside) return along + q - double{clay.inner(row)[i]};
  return along > 0.0 ? double{clay.outer(row)[i]} - (along - q) : 0.0;
}

// How often each block is looked at, row by row.
std::vector<std::vector<int>> looks(const Clay& clay, WallSide side, Vec3 at, double radius) {
  std::vector<std::vector<int>> seen(
      static_cast<std::size_t>(clay.rows()),
      std::vector<int>(static_cast<std::size_t>(clay.stride() / 8), 0));
  const BallWindow window(clay, at, radius);
  for (int j = window.first_row; j < window.end_row; j += kPlannedRows) {
    BallWindows rows;
    const int count = std::min(kPlannedRows, window.end_row - j);
    plan_rows(clay, window, side, j, count, rows);
    for (int k = 0; k < count; ++k) {
      if ((rows.reached >> k & 1u) == 0) continue;
      BlockRun ranges[2];
      const int used = blocks_of(RowShape(clay), rows, k, ranges);
      for (int n = 0; n < used; ++n)
        for (int b = ranges[n].begin; b < ranges[n].end; ++b)
          ++seen.at(static_cast<std::size_t>(j + k)).at(static_cast<std::size_t>(b));
    }
  }
  return seen;
}

// Corrections 1, 2, 3 and 5: all four quadrants, the arcsine, the wrap, the axis; and no element is
// left out where the wall is not round.
RC_GTEST_PROP(WindowProperty, HoldsEveryElementThatTheSpherePressesAndNoBlockTwice, ()) {
  Clay clay = lump(*rc::gen::inRange(8, 60), *rc::gen::inRange(16, 500));
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) * 1e-4; };
  for (int j = 0; j < clay.rows(); ++j) {
    const float dent = static_cast<float>(metres(0, 100));
    const auto i = static_cast<std::size_t>(*rc::gen::inRange(0, clay.sectors()));
    const float outer = clay.outer(j)[i] - dent;
    const float inner = j < clay.floor_rows() ? 0.0f : clay.inner(j)[i] + dent;
    clay.pressable_outer(j)[i] = outer;  // less than the extent says, which must not matter
    if (*rc::gen::arbitrary<bool>()) clay.inner_mut(j)[i] = inner;
  }
  const double radius = metres(10, 500);
  const Vec3 at{metres(-900, 900), metres(-100, 2200), metres(-900, 900)};
  const WallSide side = *rc::gen::element(WallSide::outside, WallSide::inside);
  const auto seen = looks(clay, side, at, radius);
  for (int j = 0; j < clay.rows(); ++j) {
    const std::vector<int>& row = seen[static_cast<std::size_t>(j)];
    for (int count : row) RC_ASSERT(count <= 1);
    for (int i = 0; i < clay.sectors(); ++i)
      if (press_there(clay, side, at, radius, j, i) > 8e-8)
        RC_ASSERT(row[static_cast<std::size_t>(i / 8)] == 1);
  }
}

// Elements are looked at eight at a time, which hides a window that is an element off.
TEST(Window, LiesAsFarToEitherSideOfTheTool) {
  const Clay clay = lump(40, 360);
  double off = 0.0;
  constexpr int kPlaces = 1000;
  for (int n = 0; n < kPlaces; ++n) {
    const double place = 360.0 * n / kPlaces;  // in elements, of which the first's middle is at 0.5
    const double angle = 2.0 * portable::kPi / 360.0 * place;
    const Vec3 at{0.06 * portable::cos(angle), 0.1, 0.06 * portable::sin(angle)};
    const BallWindow window(clay, at, 0.008);
    BallWindows rows;
    plan_rows(clay, window, WallSide::outside, 20, 1, rows);
    ASSERT_EQ(rows.reached, 1u);
    const double middle = 0.5 * (rows.low[0] + 1 + rows.high[0]);  // each rounded down
    off += std::remainder(middle - (place - 0.5), 360.0);
  }
  EXPECT_NEAR(off / kPlaces, 0.0, 0.02);
}

TEST(Window, LooksAtNothingWhereTheToolIsClearAndAtLittleWhereItTouchesLightly) {
  const Clay clay = lump(400, 360);
  const auto blocks = [&](double x) {
    int sum = 0;
    for (const auto& row : looks(clay, WallSide::outside, {x, 0.1, 0.0}, 0.008))
      for (int count : row) sum += count;
    return sum;
  };
  EXPECT_EQ(blocks(0.0631), 0);
  EXPECT_GT(blocks(0.0629), 0);
  EXPECT_LT(blocks(0.0629), blocks(0.0600) / 2);
}

TEST(Window, WhereTheCircleBeginsBothSidesOfATouchGiveWayAlike) {
  Clay clay = std::move(*Clay::create(ClayDef{}));
  const auto last = static_cast<std::size_t>(clay.sectors() - 1);
  const double y = clay.row_height(200);
  const Press felt =
      press_sphere(clay, WallSide::outside, {0.061, y, 0.0}, 0.008, 0.001, {0.00949, 5e6});
  EXPECT_GT(felt.force.x, 0.0);
  EXPECT_LT(std::fabs(felt.force.z), 1e-5 * felt.force.x);
  EXPECT_LT(clay.outer(200)[0], 0.0549f);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(clay.outer(200)[last - i], clay.outer(200)[i], 1e-8) << i;
}

TEST(Window, AToolOnTheAxisLooksAtTheFullCircleOnce) {
  ClayDef def;
  def.rows = 100;
  def.inner_radius = 0.003;
  const Clay clay = std::move(*Clay::create(def));
  for (double d : {0.0, 1e-12, 0.004}) {
    const auto seen = looks(clay, WallSide::inside, {d, 0.1, 0}, 0.008);
    for (int count : seen[50]) EXPECT_EQ(count, 1) << d;
  }
}

TEST(Window, CostFollowsTheToolAndNotTheGridAroundIt) {
  ClayDef tall;
  tall.rows = 4000;
  tall.height = 1.0;  // twice the rows of half the height, at the same spacing
  ClayDef low = tall;
  low.rows = 2000;
  low.height = 0.5;
  const Clay a = std::move(*Clay::create(tall));
  const Clay b = std::move(*Clay::create(low));
  const Vec3 at{0.06, 0.25, 0.0};
  EXPECT_EQ(BallWindow(a, at, 0.008).end_row, BallWindow(b, at, 0.008).end_row);
  EXPECT_EQ(BallWindow(a, at, 0.008).first_row, BallWindow(b, at, 0.008).first_row);
}

// By trying each element of each window of every width and beginning that a tool may ask for.
TEST(Window, WrappedRoundTheAxisHoldsEveryElementThatIsAskedForAndNoBlockWithoutOne) {
  for (const int sectors : {16, 24, 27, 40}) {
    const Clay clay = lump(20, sectors);
    for (int low = -sectors; low < 2 * sectors; ++low)
      for (int high = low; high < std::min(low + sectors, 2 * sectors); ++high) {
        std::vector<bool> wanted(static_cast<std::size_t>(clay.stride() / 8));
        for (int i = low; i <= high; ++i)
          wanted[static_cast<std::size_t>((i + sectors) % sectors / 8)] = true;
        BlockRun ranges[2];
        const int used = wrapped_blocks(RowShape(clay), low, high, ranges);
        std::vector<int> held(wanted.size());
        for (int n = 0; n < used; ++n)
          for (int b = ranges[n].begin; b < ranges[n].end; ++b) ++held[static_cast<std::size_t>(b)];
        for (std::size_t b = 0; b < wanted.size(); ++b)
          ASSERT_EQ(held[b], wanted[b] ? 1 : 0)
              << sectors << " sectors, " << low << " to " << high << ", block " << b;
      }
  }
}

TEST(CrossSection, KeepsItsDigitsNearThePolesWhereTheSquaresCancel) {
  const float radius = 0.008f;
  const float dy = 0.0079999f;
  const double exact = std::sqrt(static_cast<double>((static_cast<long double>(radius) - dy) *
                                                     (static_cast<long double>(radius) + dy)));
  EXPECT_NEAR(cross_section(double{radius}, double{dy}), exact, 1e-16);
  const float factored = std::sqrt((radius - dy) * (radius + dy));
  const float squares = std::sqrt(radius * radius - dy * dy);
  EXPECT_LT(std::fabs(factored - exact), 1e-10);
  EXPECT_GT(std::fabs(squares - exact), 100.0 * std::fabs(factored - exact));  // as printed
  EXPECT_EQ(cross_section(0.008, 0.008), -1.0);
}

}  // namespace
}  // namespace onggi::contact::ball_window_test
