#include "engine/surface/cut.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::cut_test {
namespace {

/// Deepest relief of a row round the sector 0, and the highest.
std::pair<int, int> range_of(const Surface& surface, int j) {
  int low = 0, high = 0;
  for (int i = -40; i <= 40; ++i) {
    low = std::min(low, surface.relief(j, wrapped(i)));
    high = std::max(high, surface.relief(j, wrapped(i)));
  }
  return {low, high};
}

std::vector<Station> upward(const Surface& surface) {
  return straight(surface, {0.015, 0.0}, {0.030, 0.0});
}

TEST(Cut, AGrooveIsAsDeepAndAsWideAsItsTool) {
  Surface surface = made(bowl());
  CutDef def;
  def.section = CutDef::flat;
  def.width = 0.002;
  def.depth = 0.0005;
  done(surface, def, upward(surface));
  const int j = 90;
  int wide = 0;
  for (int i = -40; i <= 40; ++i) {
    const int relief = surface.relief(j, wrapped(i));
    EXPECT_TRUE(relief == -500 || relief >= 0) << relief;
    wide += relief == -500;
  }
  EXPECT_NEAR(wide * surface.row(j).width * 1e-9, 0.002, 2.1 * surface.row(j).width * 1e-9 / 2.0);
}

TEST(Cut, SectionsHaveTheirForm) {
  for (const int section : {CutDef::v, CutDef::u, CutDef::sunk}) {
    Surface surface = made(bowl());
    CutDef def;
    def.section = section;
    def.width = 0.004;
    def.depth = 0.001;
    def.burr = 0.0;
    done(surface, def, upward(surface));
    const int j = 90;
    for (int i = -8; i <= 8; ++i) {
      const double x = (i + 0.5) * surface.row(j).width * 1e-9 / 0.002;  // half widths to the left
      if (std::abs(x) > 0.95) continue;
      const double form = section == CutDef::v   ? 1.0 - std::abs(x)
                          : section == CutDef::u ? std::sqrt(1.0 - x * x)
                                                 : (1.0 + x) / 2.0;
      EXPECT_NEAR(surface.relief(j, wrapped(i)), -1000.0 * form, 3.0) << section << ' ' << i;
    }
  }
}

TEST(Cut, PressureMakesItDeeper) {
  Surface surface = made(bowl());
  CutDef def;
  def.section = CutDef::flat;
  done(surface, def, straight(surface, {0.015, 0.0, 0.5}, {0.030, 0.0, 0.5}));
  EXPECT_EQ(range_of(surface, 90).first, -200);
  done(surface, def, straight(surface, {0.015, 0.0, 0.0}, {0.030, 0.0, 0.0}));
  EXPECT_EQ(range_of(surface, 90).first, -200);
}

TEST(Cut, TheSameCutAgainTakesNothing) {
  Surface surface = made(bowl());
  done(surface, CutDef{}, upward(surface));
  const std::uint64_t hash = surface.hash();
  const Work work = done(surface, CutDef{}, upward(surface));
  EXPECT_EQ(work.clay_taken, 0);
  EXPECT_EQ(surface.hash(), hash);
}

TEST(Cut, AFifthOfTheTakenClayStandsBesideIt) {
  Surface surface = made(bowl());
  CutDef def;
  def.width = 0.001;
  const Work work = done(surface, def, upward(surface));
  Volume burr = 0, gone = 0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) {
      const Volume volume = Volume{surface.relief(j, i)} * kNanometres * surface.row(j).area;
      (volume > 0 ? burr : gone) += volume;
    }
  EXPECT_EQ(-gone, work.clay_taken);
  Volume rest = 0;
  for (int j = 0; j < surface.rows(); ++j) rest += surface.rest(j, Surface::kBurrRest);
  // A unit is lost for each of the thirty pieces whose fifth is no whole number.
  EXPECT_NEAR(static_cast<double>(burr + rest), 0.2 * static_cast<double>(work.clay_taken), 31.0);
  EXPECT_GT(range_of(surface, 90).second, 0);
}

TEST(Cut, ABurrOfTheWidestAndDeepestCutIsCountedToo) {
  Surface surface = made({{{0.0, 0.040, 0.020}, {0.05, 0.040, 0.020}}});
  CutDef def;
  def.section = CutDef::flat;
  def.width = 0.01, def.depth = 0.003;
  const Work work = done(surface, def, upward(surface));
  Volume burr = 0;
  for (int j = 0; j < surface.rows(); ++j) {
    for (int i = 0; i < kSectors; ++i)
      burr += Volume{std::max(surface.relief(j, i), 0)} * kNanometres * surface.row(j).area;
    burr += surface.rest(j, Surface::kBurrRest);
    ASSERT_GE(surface.rest(j, Surface::kBurrRest), 0) << j;
  }
  // The round beginning's does not all find room.
  EXPECT_GT(burr, work.clay_taken / 10);
  EXPECT_LE(burr, work.clay_taken / 5);
}

TEST(Cut, AToolThatDoesNotPressTakesNoSlip) {
  Surface surface = made(bowl());
  done(surface, BrushDef{}, straight(surface, {0.015, 0.0}, {0.030, 0.0}));
  EXPECT_EQ(done(surface, CutDef{}, straight(surface, {0.015, 0.0, 0.0}, {0.030, 0.0, 0.0})),
            Work{});
}

TEST(Cut, NeverGoesDeeperThanTwoFifthsOfTheWall) {
  Surface surface = made({{{0.0, 0.040, 0.036}, {0.05, 0.040, 0.036}}});
  CutDef def;
  def.depth = 0.003;
  def.section = CutDef::flat;
  done(surface, def, upward(surface));
  EXPECT_EQ(range_of(surface, 90).first, -1600);
}

TEST(Cut, ACombDrawsOneLineForEachTooth) {
  Surface surface = made(bowl());
  CutDef def;
  def.teeth = 5;
  def.section = CutDef::flat;
  def.burr = 0.0;
  done(surface, def, upward(surface));
  int lines = 0;
  for (int i = -80; i < 80; ++i)
    lines += surface.relief(90, wrapped(i)) < 0 && surface.relief(90, wrapped(i + 1)) == 0;
  EXPECT_EQ(lines, 5);
}

TEST(Cut, GoesThroughSlipIntoTheClay) {
  Surface surface = made(bowl());
  BrushDef brush;
  done(surface, brush, straight(surface, {0.015, -0.02}, {0.015, 0.02}));
  const Volume before = all_slip(surface);
  const Work work = done(surface, CutDef{}, upward(surface));
  EXPECT_GT(work.slip_taken, 0);
  EXPECT_EQ(all_slip(surface), before - work.slip_taken);
  EXPECT_EQ(surface.slip(64, 0), Strata{});
  EXPECT_LT(surface.relief(64, 0), 0);
}

TEST(Cut, ASingleTouchLeavesADot) {
  Surface surface = made(bowl());
  CutDef def;
  def.width = 0.003;
  def.section = CutDef::flat;
  done(surface, def, straight(surface, {0.02, 0.0}, {0.02, 0.0}));
  EXPECT_EQ(surface.relief(80, 0), -400);
  EXPECT_EQ(surface.relief(90, 0), 0);
}

}  // namespace
}  // namespace onggi::surface_test::cut_test
