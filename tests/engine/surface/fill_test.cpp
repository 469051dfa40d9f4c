#include "engine/surface/fill.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::fill_test {
namespace {

Station corner(int along, int sector) {
  Station at;
  at.along = along;
  at.round = sector * kParts;
  return at;
}

/// 4 mm high, and as many sectors wide, from `sector` on.
std::vector<Station> square(int sector, int sectors) {
  return {corner(15000, sector), corner(15000, sector + sectors), corner(19000, sector + sectors),
          corner(19000, sector)};
}

int painted(const Surface& surface) {
  int cells = 0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) cells += surface.slip(j, i).at(0).code > 0;
  return cells;
}

TEST(Fill, CoversEachCellWhoseMiddleLiesWithin) {
  Surface surface = made(bowl());
  const Work work = done(surface, FillDef{}, square(40, 30));
  EXPECT_EQ(painted(surface), 16 * 30);
  EXPECT_EQ(surface.slip(60, 40).thickness(), surface.slip(75, 69).thickness());
  EXPECT_GT(surface.slip(60, 40).at(0).code, 0);
  EXPECT_EQ(surface.slip(59, 40).at(0).code, 0);
  EXPECT_EQ(surface.slip(60, 70).at(0).code, 0);
  EXPECT_EQ(work.slip_laid, all_slip(surface));
}

// A triangle's area, and that of a figure cut in two by any line, which no cell has twice or not at
// all.
TEST(Fill, OfTwoFiguresWithACommonEdgeExactlyOneHasEachCell) {
  Surface whole = made(bowl()), parts = made(bowl());
  const std::vector<Station> left{corner(15000, 0), corner(15000, 60), corner(18750, 37)};
  const std::vector<Station> right{corner(15000, 60), corner(18750, 97), corner(18750, 37)};
  const std::vector<Station> both{corner(15000, 0), corner(15000, 60), corner(18750, 97),
                                  corner(18750, 37)};
  done(whole, FillDef{}, both);
  done(parts, FillDef{}, left);
  const int first = painted(parts);
  EXPECT_NEAR(first, 0.5 * 60 * 15, 8);
  done(parts, FillDef{}, right);
  EXPECT_EQ(parts.hash(), whole.hash());
  Surface second = made(bowl());
  done(second, FillDef{}, right);
  EXPECT_EQ(first + painted(second), painted(whole));
}

TEST(Fill, TwiceIsOnceAndAHoleStaysBare) {
  Surface surface = made(bowl());
  done(surface, FillDef{}, square(0, 40));
  const std::uint64_t once = surface.hash();
  EXPECT_EQ(done(surface, FillDef{}, square(0, 40)).slip_laid, 0);
  EXPECT_EQ(surface.hash(), once);

  // Once round outside, back to where it began, and once round within.
  Surface ring = made(bowl());
  std::vector<Station> corners = square(0, 40);
  corners.push_back(corners[0]);
  for (const Station& at : {corner(16000, 10), corner(16000, 30), corner(18000, 30),
                            corner(18000, 10), corner(16000, 10)})
    corners.push_back(at);
  done(ring, FillDef{}, corners);
  EXPECT_EQ(painted(ring), 16 * 40 - 8 * 20);
}

TEST(Fill, CoversNoResistAndTakesTheShineOff) {
  Surface surface = made(bowl());
  done(surface, BurnishDef{}, straight(surface, {0.017, 0.0}, {0.017, 0.02}));
  ResistDef wax;
  wax.width = 0.001;
  done(surface, wax, straight(surface, {0.015, 0.02}, {0.019, 0.02}));
  ASSERT_TRUE(surface.resist(68, 34));
  ASSERT_GT(surface.burnish(68, 5), 0);
  done(surface, FillDef{}, square(0, 60));
  EXPECT_EQ(surface.slip(68, 34).at(0).code, 0);
  EXPECT_EQ(surface.burnish(68, 5), 0);
}

}  // namespace
}  // namespace onggi::surface_test::fill_test
