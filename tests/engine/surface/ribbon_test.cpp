#include "engine/surface/ribbon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::ribbon_test {
namespace {

using Counts = std::map<std::pair<int, int>, int>;

Counts cells_of(const Surface& surface, const Quad& quad) {
  Counts counts;
  each_cell_in(surface, quad, [&](int j, int i) { ++counts[{j, i}]; });
  return counts;
}

TEST(Ribbon, AQuadHasTheCellsWhoseMiddlesLieInIt) {
  const Surface surface = made(bowl());
  const Quad quad{{{1000, 0}, {2000, 0}, {2000, 10 * kParts}, {1000, 10 * kParts}}};
  const Counts counts = cells_of(surface, quad);
  EXPECT_EQ(counts.size(), 40u);
  for (const auto& [cell, count] : counts) {
    EXPECT_EQ(count, 1);
    EXPECT_GE(cell.first, 4);
    EXPECT_LT(cell.first, 8);
    EXPECT_LT(cell.second, 10);
  }
}

TEST(Ribbon, NeighboursShareNoCellAndLeaveNoneOut) {
  const Surface surface = made(bowl());
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    // A square with a point somewhere in it, and the four triangles that meet there.
    const auto place = [&](double low, double high) {
      return Corner{static_cast<std::int64_t>(random.uniform(low, high)),
                    static_cast<std::int64_t>(random.uniform(-20.0, 20.0) * kParts)};
    };
    const std::array<Corner, 4> square{
        {{2000, -30 * kParts}, {9000, -30 * kParts}, {9000, 30 * kParts}, {2000, 30 * kParts}}};
    // Often exactly on a cell's middle.
    const Corner middle = trial % 3 == 0 ? Corner{4125, 512} : place(3000, 8000);
    Counts counts;
    for (std::size_t k = 0; k < 4; ++k)
      for (const auto& [cell, count] :
           cells_of(surface, {square[k], square[(k + 1) % 4], middle, middle}))
        counts[cell] += count;
    EXPECT_EQ(counts, cells_of(surface, {square[0], square[1], square[2], square[3]}));
  }
}

TEST(Ribbon, AStrokesPiecesCoverItsAreaOnce) {
  const Surface surface = made(bowl());
  // A wavy way, as a hand draws, of a tool as wide as its bends allow.
  Tracer tracer(surface, 0.4);
  for (int n = 0; n <= 100; ++n) tracer.go({0.03 + 0.004 * portable::sin(n * 0.2), n * 0.004});
  tracer.lift();
  Counts counts;
  const auto& way = tracer.stations();
  for (std::size_t n = 1; n < way.size(); ++n)
    each_cell_in(surface, piece(surface, way[n - 1], way[n], -1500, 1500, -1500, 1500),
                 [&](int j, int i) {
                   ++counts[{j, i}];
                 });
  double area = 0.0;
  int twice = 0;
  for (const auto& [cell, count] : counts) {
    area += surface.row(cell.first).area;
    twice += count > 1;
  }
  EXPECT_EQ(twice, 0);
  EXPECT_NEAR(area, 3000.0 * 500.0 * static_cast<double>(way.size() - 1), 0.02 * area);
}

TEST(Ribbon, CellsNearAWayHaveTheirDistanceAndSide) {
  const Surface surface = made(bowl());
  const int row = 120;
  const double width = surface.row(row).width * 1e-3;  // um
  const Corner a{30125, 100 * kParts + 512}, b{33125, 100 * kParts + 512};
  int seen = 0;
  each_cell_near(surface, a, b, 1000, [&](int j, int i, std::int64_t distance, std::int64_t left) {
    const double y = j * 250.0 + 125.0, x = (i - 100) * surface.row(j).width * 1e-3;
    const double beyond = std::max({30125.0 - y, y - 33125.0, 0.0});
    EXPECT_NEAR(static_cast<double>(distance), std::hypot(beyond, x), 1.5);
    EXPECT_LE(distance, 1000);
    EXPECT_NEAR(static_cast<double>(left), x, 1.5);
    ++seen;
  });
  EXPECT_NEAR(seen, (2000.0 * 3000.0 + 3.1416 * 1e6) / (250.0 * width), 8.0);
}

TEST(Ribbon, NothingLeavesTheOutline) {
  const Surface surface = made(bowl());
  int seen = 0;
  const auto check = [&](int j, int i) {
    ASSERT_GE(j, 0);
    ASSERT_LT(j, surface.rows());
    ASSERT_GE(i, 0);
    ASSERT_LT(i, kSectors);
    ++seen;
  };
  each_cell_in(surface, {{{-5000, -9000}, {999999, -9000}, {999999, 9000}, {-5000, 9000}}}, check);
  EXPECT_EQ(seen, surface.rows() * 18);
  each_cell_near(surface, {-500, 0}, {0, 0}, 2000,
                 [&](int j, int i, std::int64_t, std::int64_t) { check(j, i); });
  const std::int64_t end = surface.rows() * kRowHeight;
  each_cell_near(surface, {end, 0}, {end + 900, 0}, 2000,
                 [&](int j, int i, std::int64_t, std::int64_t) { check(j, i); });
}

}  // namespace
}  // namespace onggi::surface_test::ribbon_test
