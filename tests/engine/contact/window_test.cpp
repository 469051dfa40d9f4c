#include "engine/contact/window.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "engine/math/portable.h"

namespace onggi {
namespace {

Clay lump(int rows, int sectors) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  return std::move(*Clay::create(def));
}

// Whether the sphere at `at` meets the ray of (row, sector), by plain geometry in double.
bool meets(const Clay& clay, Vec3 at, double radius, int row, int sector) {
  const double angle = (sector + 0.5) * 2.0 * portable::kPi / clay.sectors();
  const double dy = at.y - clay.row_height(row);
  if (std::fabs(dy) >= radius) return false;
  const double r = std::sqrt(radius * radius - dy * dy);
  const double along = at.x * std::cos(angle) + at.z * std::sin(angle);
  const double off = std::fabs(at.z * std::cos(angle) - at.x * std::sin(angle));
  return off < r && along + std::sqrt(r * r - off * off) > 0.0;
}

// Corrections 1, 2, 3 and 5: all four quadrants, the arcsine, the wrap, the axis.
RC_GTEST_PROP(WindowProperty, HoldsEveryElementThatTheSphereCanReachAndNoBlockTwice, ()) {
  const Clay clay = lump(*rc::gen::inRange(8, 60), *rc::gen::inRange(16, 500));
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) * 1e-4; };
  const double radius = metres(10, 500);
  const Vec3 from{metres(-900, 900), metres(-100, 2200), metres(-900, 900)};
  const double far = 0.25 * radius;
  const Vec3 to =
      from + Vec3{far * *rc::gen::inRange(-5, 6) / 10, far * *rc::gen::inRange(-5, 6) / 10,
                  far * *rc::gen::inRange(-5, 6) / 10};
  const Window window(clay, from, to, radius);
  for (int j = 0; j < clay.rows(); ++j) {
    std::vector<int> seen(static_cast<std::size_t>(clay.stride() / 8), 0);
    if (j >= window.first_row() && j < window.end_row()) {
      const double h = clay.row_height(j);
      const double section =
          std::max(cross_section(radius, from.y - h), cross_section(radius, to.y - h));
      BlockRange ranges[2];
      const int used = window.blocks(section, ranges);
      for (int n = 0; n < used; ++n)
        for (int b = ranges[n].begin; b < ranges[n].end; ++b)
          ++seen.at(static_cast<std::size_t>(b));
    }
    for (int count : seen) RC_ASSERT(count <= 1);
    for (int i = 0; i < clay.sectors(); ++i)
      if (meets(clay, from, radius, j, i) || meets(clay, to, radius, j, i))
        RC_ASSERT(seen[static_cast<std::size_t>(i / 8)] == 1);
  }
}

TEST(Window, ThePrintedWindowMissesAFifthOfTheAngleWhereTheToolIsNearlyAtTheAxis) {
  // Lee, Han & Choi 2008, eq. 2: +- H_r / d. The sphere reaches +- asin(H_r / d).
  for (const auto& [ratio, missed] : {std::pair{0.5, 0.045}, std::pair{0.9, 0.196}})
    EXPECT_NEAR(1.0 - ratio / portable::asin(ratio), missed, 0.002);
}

TEST(Window, AToolOnTheAxisLooksAtTheFullCircleOnce) {
  const Clay clay = lump(100, 360);
  for (double d : {0.0, 1e-12, 0.004}) {
    const Window window(clay, {d, 0.1, 0}, {d, 0.1, 0}, 0.008);
    BlockRange ranges[2];
    ASSERT_EQ(window.blocks(0.008, ranges), 1);
    EXPECT_EQ(ranges[0].begin, 0);
    EXPECT_EQ(ranges[0].end, 45);
    EXPECT_EQ(window.blocks(-1.0, ranges), 0);
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
  EXPECT_EQ(Window(a, at, at, 0.008).end_row(), Window(b, at, at, 0.008).end_row());
  EXPECT_EQ(Window(a, at, at, 0.008).first_row(), Window(b, at, at, 0.008).first_row());
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
}  // namespace onggi
