#include "engine/surface/brush.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::brush_test {
namespace {

/// Mean thickness of slip across a stroke up the pot, at row j, nm; and its width in cells.
std::pair<double, int> coat_at(const Surface& surface, int j) {
  double sum = 0.0;
  int cells = 0;
  for (int i = -100; i <= 100; ++i) {
    const int nm = surface.slip(j, wrapped(i)).thickness();
    sum += nm;
    cells += nm > 0;
  }
  return {cells == 0 ? 0.0 : sum / cells, cells};
}

TEST(Brush, SlipOnThePotIsWhatTheBrushGaveToTheLastUnit) {
  Surface surface = made(bowl());
  BrushDef def;
  def.fill = 0.67;
  done(surface, CutDef{}, straight(surface, {0.015, 0.0}, {0.030, 0.0}));
  const Work work = done(surface, def, straight(surface, {0.012, -0.02}, {0.035, 0.03}));
  EXPECT_GT(work.slip_laid, 0);
  EXPECT_EQ(all_slip(surface), work.slip_laid);
  EXPECT_EQ(surface.slip_volume(def.pigment), work.slip_laid);
}

TEST(Brush, ItsCoatIsEvenForMoreThanHalfTheWayThenThinnerAndNarrower) {
  Surface surface = made(jar());
  BrushDef def;
  def.reach = 0.1;
  done(surface, def, straight(surface, {0.010, 0.0}, {0.110, 0.0}, def.reach));
  const auto at = [&](double along) { return coat_at(surface, static_cast<int>(along / 2.5e-4)); };
  EXPECT_NEAR(at(0.065).first, at(0.015).first, 0.03 * at(0.015).first);
  EXPECT_LT(at(0.095).first, 0.6 * at(0.015).first);
  const double first_wide = at(0.015).second * surface.row(60).width * 1e-9;
  EXPECT_NEAR(first_wide, 0.010, 0.0006);
  EXPECT_LT(at(0.095).second * surface.row(380).width * 1e-9, 0.8 * first_wide);
  EXPECT_EQ(at(0.1095).second, 0);
}

TEST(Brush, AtTheEndOfItsLoadItStreaks) {
  Surface surface = made(jar());
  BrushDef def;
  def.reach = 0.1;
  done(surface, def, straight(surface, {0.010, 0.0}, {0.110, 0.0}, def.reach));
  const int j = 356;  // 89 mm: a fifth of the load is left
  int streaks = 0;
  for (int i = -100; i <= 100; ++i)
    streaks += surface.slip(j, wrapped(i)).thickness() > 0 &&
               surface.slip(j, wrapped(i + 1)).thickness() == 0;
  EXPECT_GE(streaks, 2);
}

TEST(Brush, ABandOnTheTurningWheelHasNoSeam) {
  Surface surface = made(bowl());
  BrushDef def;
  def.tracks = 1;
  done(surface, def, band(surface, 0.03, 100.0));
  for (int i = 0; i < kSectors; ++i) {
    const int nm = surface.slip(120, i).thickness();
    ASSERT_NEAR(nm, 150'000, 0.2 * 150'000) << i;
  }
}

TEST(Brush, LaysNothingOnResistAndBrushesBurrsOff) {
  Surface surface = made(bowl());
  done(surface, CutDef{}, straight(surface, {0.015, 0.0}, {0.030, 0.0}));
  ResistDef wax;
  done(surface, wax, straight(surface, {0.020, 0.0}, {0.020, 0.0}));
  done(surface, BrushDef{}, straight(surface, {0.014, 0.0}, {0.031, 0.0}));
  EXPECT_EQ(surface.slip(80, 3), Strata{});
  EXPECT_NE(surface.slip(110, 3), Strata{});
  for (int j = 65; j < 115; ++j)
    for (int i = -10; i <= 10; ++i) ASSERT_LE(surface.relief(j, wrapped(i)), 0);
}

TEST(Brush, FillsAHollowByItsShare) {
  Surface surface = made(bowl());
  CutDef groove;
  groove.section = CutDef::flat;
  groove.width = 0.0015, groove.depth = 0.001;
  done(surface, groove, straight(surface, {0.015, 0.0}, {0.030, 0.0}));
  BrushDef def;
  def.tracks = 1, def.fill = 0.67;
  done(surface, def, straight(surface, {0.014, 0.0}, {0.031, 0.0}));
  EXPECT_NEAR(surface.slip(90, 0).thickness(), 150'000 + 670'000, 0.1 * 820'000);
  EXPECT_NEAR(surface.slip(90, 15).thickness(), 150'000, 0.1 * 150'000);
}

/// White across, then a brush with black up through it.
struct Crossed {
  Surface surface = made(bowl());
  Volume white = 0, black = 0;
  int beyond = 0;  ///< Cells with white above the band.

  explicit Crossed(double age, double drags = 0.1) {
    BrushDef def;
    def.thickness = 4e-4;
    white = done(surface, def, straight(surface, {0.022, -0.1}, {0.022, 0.1})).slip_laid;
    def.pigment = 1, def.drags = drags, def.thickness = 5e-5, def.width = 0.006;
    black = done(surface, def, straight(surface, {0.012, 0.0, 1.0, age}, {0.04, 0.0, 1.0, age}))
                .slip_laid;
    for (int j = 112; j < surface.rows(); ++j)  // 28 mm
      for (int i = 0; i < kSectors; ++i)
        for (int k = 0; k < kStrata; ++k) {
          const Stratum stratum = surface.slip(j, i).at(k);
          beyond += stratum.code > 0 && stratum.pigment == 0;
        }
  }
};

TEST(Brush, TakesSomeOfTheWetSlipUnderItAlongAndLosesNone) {
  const Crossed wet(0.0);
  EXPECT_GT(wet.beyond, 100);
  EXPECT_EQ(all_slip(wet.surface), wet.white + wet.black);
  EXPECT_EQ(wet.surface.slip_volume(0) + wet.surface.slip_volume(1), wet.white + wet.black);
}

TEST(Brush, DrySlipStaysWhereItIs) {
  EXPECT_EQ(Crossed(10.0).beyond, 0);
  EXPECT_EQ(Crossed(0.0, 0.0).beyond, 0);
  EXPECT_EQ(Crossed(10.0).surface.hash(), Crossed(0.0, 0.0).surface.hash());
}

TEST(Brush, OfWetSlipATenthIsGoneFromWhereTheBrushWent) {
  Surface surface = made(bowl());
  BrushDef def;
  def.thickness = 4e-4, def.tracks = 1;
  done(surface, def, band(surface, 0.022, 100.0));
  const auto white = [&](int i) {
    double sum = 0.0;
    for (int j = 72; j < 104; ++j)
      for (int k = 0; k < kStrata; ++k) {
        const Stratum stratum = surface.slip(j, wrapped(i)).at(k);
        if (stratum.pigment == 0) sum += thickness_of(stratum.code);
      }
    return sum;
  };
  double before = 0.0, after = 0.0;
  for (int i = -8; i <= 8; ++i) before += white(i);
  def.pigment = 1;
  done(surface, def, straight(surface, {0.012, 0.0}, {0.04, 0.0}));
  for (int i = -8; i <= 8; ++i) after += white(i);
  // A piece's tenth comes from the piece behind it: only what left the band is missing.
  EXPECT_LT(after, 0.995 * before);
  EXPECT_GT(after, 0.9 * before);
}

TEST(Brush, LightPressureIsNarrow) {
  Surface surface = made(bowl());
  done(surface, BrushDef{}, straight(surface, {0.014, 0.0, 0.25}, {0.031, 0.0, 0.25}));
  EXPECT_NEAR(coat_at(surface, 90).second * surface.row(90).width * 1e-9, 0.01 * 0.625, 0.0004);
}

}  // namespace
}  // namespace onggi::surface_test::brush_test
