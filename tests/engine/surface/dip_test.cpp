#include "engine/surface/dip.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::dip_test {
namespace {

TEST(Dip, TheCoatGrowsWithTheRootOfTime) {
  for (const double seconds : {1.0, 4.0}) {
    Surface surface = made(jar());
    DipDef def = whole_dip();
    def.seconds = seconds;
    const Work work = done(surface, def);
    EXPECT_EQ(surface.glaze(300, 17), seconds == 1.0 ? 100 : 200);  // 0.4 and 0.8 mm
    EXPECT_EQ(surface.glaze_volume(), work.glaze_laid);
  }
}

TEST(Dip, TwiceTheHalfIsTheWholeToAUnit) {
  Surface once = made(jar()), twice = made(jar());
  DipDef def = whole_dip();
  def.seconds = 3.0;
  done(once, def);
  def.seconds = 1.5;
  done(twice, def), done(twice, def);
  for (int j = 0; j < once.rows(); ++j) ASSERT_NEAR(once.glaze(j, 5), twice.glaze(j, 5), 1) << j;
}

TEST(Dip, AThinWallDrinksLess) {
  Surface surface = made({{{0.0, 0.030, 0.029}, {0.05, 0.030, 0.029}}});
  done(surface, whole_dip());
  EXPECT_EQ(surface.glaze(100, 0), 249'999 / kGlazeUnit);  // a quarter of a millimetre
}

TEST(Dip, OnlyItsZoneIsUnder) {
  Surface surface = made(jar());
  DipDef def = whole_dip();
  def.from = 0.010, def.to = 0.020;
  done(surface, def);
  EXPECT_EQ(surface.glaze(39, 0), 0);
  EXPECT_GT(surface.glaze(40, 0), 0);
  EXPECT_GT(surface.glaze(79, 0), 0);
  EXPECT_EQ(surface.glaze(80, 0), 0);
}

TEST(Dip, FingersLeaveTheirMarks) {
  Surface surface = made(bowl());
  const auto held = straight(surface, {0.010, 0.25}, {0.010, 0.25});
  done(surface, ResistDef{}, held);
  const Work work = done(surface, whole_dip());
  ResistDef lets_go;
  lets_go.lifts = true;
  done(surface, lets_go, held);
  EXPECT_EQ(surface.glaze(40, kSectors / 4), 0);
  EXPECT_GT(surface.glaze(40, 0), 0);
  EXPECT_FALSE(surface.resist(40, kSectors / 4));
  EXPECT_EQ(surface.glaze_volume(), work.glaze_laid);
}

TEST(Dip, SlipOverSlipIsAnotherStratum) {
  Surface surface = made(jar());
  DipDef def = whole_dip(7);
  const Work first = done(surface, def);
  EXPECT_EQ(surface.slip(300, 0).at(0), (Stratum{code_within(800'000), 7}));
  def.coat = 2;
  const Work second = done(surface, def);
  EXPECT_EQ(surface.slip(300, 0).at(0).pigment, 2);
  EXPECT_EQ(surface.slip(300, 0).at(1).pigment, 7);
  EXPECT_EQ(surface.slip_volume(7), first.slip_laid);
  EXPECT_EQ(surface.slip_volume(2), second.slip_laid);
}

}  // namespace
}  // namespace onggi::surface_test::dip_test
