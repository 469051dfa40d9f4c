#include "engine/surface/imprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/portable.h"
#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::imprint_test {
namespace {

constexpr double kRadius = 0.0668451;  // where a cell is 0.25 mm wide

Surface cylinder() { return made({{{0.0, kRadius, 0.060}, {0.1, kRadius, 0.060}}}); }

// A face of 20 mm that struck in the middle of the wall, `cells` round the pot.
Impression blow(int face, int cells = 0, double deep = 0.003) {
  Impression left;
  left.face = face;
  left.low = 0.030, left.high = 0.070;
  left.angle = 2.0 * portable::kPi * (cells + 0.5) / kSectors;
  left.half = 0.020 / kRadius;
  left.wide = left.tall = 0.020;
  left.deep = deep;
  return left;
}
// 0.25 mm each, from the face's middle.
int relief_at(const Surface& surface, int round, int up) {
  return surface.relief(200 + up, wrapped(round));
}
int outside_rows(const Surface& surface) {
  int rows = 0;
  while (surface.row(rows).part == Part::outside) ++rows;
  return rows;
}

TEST(Imprint, CordsLieSideBySideAsDeepAsToldAndNothingStandsOut) {
  Surface surface = cylinder();
  const Impression left = blow(Impression::cord);
  ASSERT_TRUE(imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4}));
  int deepest = 0, highest = -1000;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) {
      deepest = std::min(deepest, surface.relief(j, i));
      highest = std::max(highest, surface.relief(j, i));
    }
  EXPECT_GE(deepest, -300);
  EXPECT_LE(deepest, -280);
  EXPECT_EQ(highest, 0);
  // A ridge every 2 mm, 8 cells, upright.
  for (const int up : {-20, 0, 20})
    for (int k = -4; k <= 4; ++k) {
      EXPECT_GT(relief_at(surface, 8 * k, up), -80) << k << ' ' << up;
      EXPECT_LT(relief_at(surface, 8 * k + 4, up), -100) << k << ' ' << up;
    }
}

TEST(Imprint, AGridIsRaisedLinesAcrossEachOther) {
  Surface surface = cylinder();
  const Impression left = blow(Impression::grid);
  imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4});
  for (int k = -3; k <= 3; ++k) {
    EXPECT_EQ(relief_at(surface, 8 * k, 4), 0) << k;
    EXPECT_EQ(relief_at(surface, 4, 8 * k), 0) << k;
    EXPECT_EQ(relief_at(surface, 8 * k + 4, 4), -300) << k;
  }
}

TEST(Imprint, AnAnvilsRingsLieRoundItsMiddleInside) {
  Surface surface = cylinder();
  Impression left = blow(Impression::rings);
  left.inside = true;
  imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4});
  for (int j = 0; j < outside_rows(surface); ++j) ASSERT_EQ(surface.relief(j, 0), 0);
  const auto middle = [&] {
    for (int j = 0; j < surface.rows(); ++j)
      if (surface.row(j).part == Part::inside && surface.row(j).height < 0.05) return j;
    return 0;
  }();
  for (const int ring : {0, 1, 2}) {
    EXPECT_LT(surface.relief(middle + 12 * ring, 0), -270) << ring;
    EXPECT_GT(surface.relief(middle + 12 * ring + 6, 0), -60) << ring;
    EXPECT_GT(surface.relief(middle - 12 * ring - 6, 0), -60) << ring;
  }
}

TEST(Imprint, TheFaceGivesWayRoundItsEdge) {
  Surface surface = cylinder();
  const Impression left = blow(Impression::grid);
  imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4});
  for (int i = 0; i < kSectors; ++i)
    for (int j = 0; j < outside_rows(surface); ++j) {
      const double x = (i < kSectors / 2 ? i : i - kSectors) * 0.25;
      const double y = (j - 199.5) * 0.25;
      if (std::hypot(x, y) > 20.3) {
        ASSERT_EQ(surface.relief(j, i), 0) << i << " " << j;
      }
    }
}

TEST(Imprint, ALaterBlowWipesOutAnEarlierOneAndALightOneHalf) {
  const ImprintDef def{0.002, 0.003, 3e-4};
  Surface both = cylinder(), last = cylinder(), light = cylinder(), first = cylinder();
  const Impression grid = blow(Impression::grid), cord = blow(Impression::cord, 3);
  const Impression two[] = {grid, cord};
  imprint(both, two, def);
  imprint(last, {&cord, 1}, def);
  for (int up = -30; up <= 30; up += 3)
    for (int round = -30; round <= 30; round += 3)
      ASSERT_NEAR(relief_at(both, round, up), relief_at(last, round, up), 1);
  const Impression even_light[] = {grid, blow(Impression::even, 0, 1.5e-4)};
  imprint(light, even_light, def);
  imprint(first, {&grid, 1}, def);
  EXPECT_NEAR(relief_at(light, 4, 4), relief_at(first, 4, 4) / 2, 6);
}

TEST(Imprint, AHandSmoothsItsFieldAndNoMore) {
  Surface surface = cylinder();
  Impression hand = blow(Impression::even);
  hand.hand = true;
  hand.low = 0.045, hand.high = 0.055;
  hand.half = portable::kPi;
  const Impression left[] = {blow(Impression::grid), hand};
  EXPECT_TRUE(imprint(surface, left, {0.002, 0.003, 3e-4}));
  for (int up = -14; up <= 14; ++up) ASSERT_EQ(relief_at(surface, 4, up), 0) << up;
  EXPECT_EQ(relief_at(surface, 4, 28), -300);
  const Impression gone[] = {blow(Impression::grid, 0, 0.003), blow(Impression::even, 0, 1.0)};
  Surface plain = cylinder();
  imprint(plain, gone, {0.002, 0.003, 3e-4});
  EXPECT_EQ(relief_at(plain, 4, 4), 0);
}

TEST(Imprint, PlainWoodLeavesNothingAndTakesNoMemory) {
  Surface surface = cylinder(), bare = cylinder();
  const Impression left = blow(Impression::even);
  EXPECT_FALSE(imprint(surface, {&left, 1}, {}));
  EXPECT_FALSE(imprint(surface, {}, {}));
  EXPECT_EQ(surface.hash(), bare.hash());
  EXPECT_EQ(surface.bytes(), bare.bytes());
}

TEST(Imprint, TurnedByWholeSectorsItIsTheSameTurned) {
  Surface here = cylinder(), there = cylinder();
  const Impression a[] = {blow(Impression::cord), blow(Impression::grid, 40)};
  const Impression b[] = {blow(Impression::cord, 900), blow(Impression::grid, 940)};
  imprint(here, a, {}), imprint(there, b, {});
  int apart = 0;
  for (int j = 0; j < outside_rows(here); ++j)
    for (int i = 0; i < kSectors; ++i)
      apart = std::max(apart, std::abs(here.relief(j, i) - there.relief(j, wrapped(i + 900))));
  EXPECT_LE(apart, 12) << "of 300: the place in a pattern rounds to 64 parts";
}

TEST(Imprint, NoPrintIsDeeperThanTheWallBears) {
  Surface surface = made({{{0.0, 0.0605, 0.060}, {0.1, 0.0605, 0.060}}});
  const Impression left = blow(Impression::grid);
  imprint(surface, {&left, 1}, {0.002, 0.003, 0.002});
  EXPECT_EQ(relief_at(surface, 4, 4), -surface.deepest(204));
}

TEST(Imprint, AFaceThatLeansLeansItsCords) {
  Surface surface = cylinder();
  Impression left = blow(Impression::cord);
  left.tilt = portable::kPi / 2.0;
  imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4});
  for (int k = -4; k <= 4; ++k) EXPECT_GT(relief_at(surface, 20, 8 * k), -80) << k;
}

TEST(Imprint, AFaceThatReachesOverTheRimIsCutOffThere) {
  Surface whole = cylinder(), over = cylinder();
  const Impression left = blow(Impression::rings);
  Impression half = left;
  half.high = 0.050, half.to = 0.0;
  imprint(whole, {&left, 1}, {}), imprint(over, {&half, 1}, {});
  for (int up = -80; up < -1; ++up)
    ASSERT_EQ(relief_at(over, 3, up), relief_at(whole, 3, up)) << up;
  EXPECT_LT(relief_at(over, 3, -2), -150) << "it is as deep there as in its middle";
  EXPECT_EQ(relief_at(over, 3, 1), 0);
}

TEST(Imprint, ATiltTurnsTheFaceFromTheSectorsWayTowardsUp) {
  // By half a right angle: a cord goes up as it goes back round, against the sectors.
  for (const int way : {1, -1}) {
    Surface surface = cylinder();
    Impression left = blow(Impression::cord);
    left.tilt = way * portable::kPi / 4.0;
    imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4});
    int along = 0, across = 0;
    for (int k = -12; k <= 12; ++k)
      along += std::abs(relief_at(surface, -way * k, k)),
          across += std::abs(relief_at(surface, way * k, k));
    EXPECT_LT(along, across / 2) << way << ": along the ridge there is nothing";
  }
}

TEST(Imprint, WhereTheClayStretchedThePatternDid) {
  Surface surface = cylinder();
  Impression left = blow(Impression::grid);
  // It struck at half the size: bars every 2 mm lie 4 mm apart now, round and up.
  left.wide = left.tall = 0.010;
  imprint(surface, {&left, 1}, {0.002, 0.003, 3e-4});
  for (int k = -2; k <= 2; ++k) {
    EXPECT_EQ(relief_at(surface, 16 * k, 8), 0) << k;
    EXPECT_EQ(relief_at(surface, 8, 16 * k), 0) << k;
    EXPECT_EQ(relief_at(surface, 16 * k + 8, 8), -300) << k;
    EXPECT_EQ(relief_at(surface, 8, 16 * k + 8), -300) << k;
  }
}

TEST(Imprint, AHandsFieldRunsOutOverAQuarterAndWhereItIsCutOffItDoesNot) {
  const ImprintDef def{0.002, 0.003, 3e-4};
  Impression hand = blow(Impression::even);
  hand.hand = true;
  hand.low = 0.046, hand.high = 0.054;
  hand.half = portable::kPi;
  const Impression left[] = {blow(Impression::grid), hand};
  Surface surface = cylinder(), cut = cylinder();
  imprint(surface, left, def);
  // 4 mm, 16 cells, of which the last four run out.
  EXPECT_EQ(relief_at(surface, 4, 11), 0);
  EXPECT_LT(relief_at(surface, 4, 13), -60);
  EXPECT_GT(relief_at(surface, 4, 13), -240);
  EXPECT_EQ(relief_at(surface, 4, 20), -300);
  Impression half[] = {left[0], hand};
  half[1].high = 0.050, half[1].to = 0.0;
  imprint(cut, half, def);
  EXPECT_EQ(relief_at(cut, 4, -2), 0);
  EXPECT_EQ(relief_at(cut, 4, 4), -300);
}

TEST(Imprint, AHandOutsideLeavesTheInsideAsItIs) {
  const ImprintDef def{0.002, 0.003, 3e-4};
  Impression rings = blow(Impression::rings), hand = blow(Impression::even);
  rings.inside = true;
  hand.hand = true;
  hand.half = portable::kPi;
  Surface alone = cylinder(), both = cylinder();
  const Impression left[] = {rings, hand};
  imprint(alone, {&rings, 1}, def), imprint(both, left, def);
  EXPECT_EQ(alone.hash(), both.hash());
}

TEST(Imprint, AFaceWhoseMiddleMissedTheWallIsAsDeepAsToldWhereItStruck) {
  Surface surface = cylinder();
  Impression left = blow(Impression::grid, 0, 2e-4);
  left.high = 0.040, left.to = -0.5;
  imprint(surface, {&left, 1}, {0.002, 0.003, 4e-4});
  int deepest = 0;
  for (int up = -80; up < -40; ++up) deepest = std::min(deepest, relief_at(surface, 4, up));
  EXPECT_LE(deepest, -170);
  EXPECT_GE(deepest, -200);
}

TEST(Imprint, NumbersThatAreNonePrintNothing) {
  const double none = std::nan("");
  for (const double bad : {none, HUGE_VAL, -HUGE_VAL, 1e300})
    for (double Impression::*number :
         {&Impression::low, &Impression::high, &Impression::from, &Impression::to,
          &Impression::angle, &Impression::half, &Impression::wide, &Impression::tall,
          &Impression::deep, &Impression::tilt})
      for (const int face : {Impression::cord, Impression::rings}) {
        Surface surface = cylinder();
        Impression left = blow(face);
        left.*number = bad;
        EXPECT_FALSE(imprint(surface, {&left, 1}, {}));
      }
}

TEST(Imprint, IsNoStepOfTheUndo) {
  Surface surface = cylinder();
  const Impression left = blow(Impression::cord);
  imprint(surface, {&left, 1}, {});
  EXPECT_FALSE(surface.can_undo());
  EXPECT_EQ(surface.undo_bytes(), cylinder().undo_bytes());
}

}  // namespace
}  // namespace onggi::surface_test::imprint_test
