#include "engine/surface/coil.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::coil_test {
namespace {

TEST(Coil, ABeadStandsAllRoundWithAsManyNailMarksAsAsked) {
  Surface surface = made(bowl());
  CoilDef def;
  def.marks = 40;
  done(surface, def, band(surface, 0.03));
  const int j = 120;
  int highest = 0, marks = 0;
  for (int i = 0; i < kSectors; ++i) highest = std::max(highest, surface.relief(j, i));
  EXPECT_NEAR(highest, 2000, 20);
  for (int i = 0; i < kSectors; ++i)
    marks += surface.relief(j, i) < 1400 && surface.relief(j, wrapped(i + 1)) >= 1400;
  EXPECT_EQ(marks, 40);
  EXPECT_EQ(surface.relief(j - 14, 0), 0);
  EXPECT_EQ(surface.relief(j + 14, 0), 0);
}

TEST(Coil, TheClayThatItTellsStandsOnThePot) {
  Surface surface = made(bowl());
  const Work work = done(surface, CoilDef{}, band(surface, 0.03));
  Volume stands = 0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      stands += Volume{surface.relief(j, i)} * kNanometres * surface.row(j).area;
  EXPECT_EQ(stands, work.clay_laid);
  EXPECT_GT(stands, 0);
  EXPECT_EQ(done(surface, CoilDef{}, band(surface, 0.03)).clay_laid, 0);
}

TEST(Coil, ABrushLeavesItAndAScraperDoesNot) {
  Surface surface = made(bowl());
  done(surface, CoilDef{}, band(surface, 0.03));
  const int before = surface.relief(120, 7);
  ASSERT_GT(before, 500);
  done(surface, BrushDef{}, band(surface, 0.03));
  EXPECT_EQ(surface.relief(120, 7), before);
  EXPECT_GT(surface.slip(120, 7).thickness(), 0);
  done(surface, ScrapeDef{}, band(surface, 0.03));
  EXPECT_LE(surface.relief(120, 7), 0);
  // What a cut raises there now is a burr again.
  EXPECT_FALSE(surface.coil(120, 7));
}

TEST(Coil, WithoutPressureOrWithoutANailItIsPlain) {
  Surface surface = made(bowl());
  CoilDef plain;
  plain.press = 0.0;
  done(surface, plain, band(surface, 0.03));
  for (int i = 0; i < kSectors; ++i) ASSERT_NEAR(surface.relief(120, i), 1995, 10) << i;
  Surface bare = made(bowl());
  done(bare, CoilDef{}, straight(bare, {0.03, 0.0, 0.0}, {0.03, 0.5, 0.0}));
  EXPECT_EQ(bare.hash(), made(bowl()).hash());
}

}  // namespace
}  // namespace onggi::surface_test::coil_test
