#include "engine/surface/melt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/math/hash.h"
#include "engine/math/portable.h"
#include "tests/engine/surface/random_strokes.h"

namespace onggi::surface_test::melt_test {
namespace {

/// Of the pot of TheSameGlazeMeltsToTheSameBitsOnEveryMachine.
constexpr std::uint64_t kGolden = 0x9164bdb0223527db;
constexpr int kAsRaw = kGlazeUnit / Melt::kUnit;

/// A straight wall, 45 mm in radius and 90 mm high.
Profile tube() { return {{{0.0, 0.045, 0.0}, {0.006, 0.045, 0.039}, {0.09, 0.045, 0.039}}}; }

Melt melted(const Surface& surface, const MeltDef& def = {}) {
  Result<Melt> melt = Melt::begin(surface, def);
  EXPECT_TRUE(melt) << (melt ? "" : to_text(melt.error()));
  while (!melt->go_on(1'000'000)) {
  }
  return std::move(*melt);
}

/// A tube whose glaze, 0.4 mm raw, has a wave of 0.16 mm on it.
Surface rippled(const std::function<double(int, int)>& phase) {
  Surface surface = made(tube());
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) {
      const double wave = 40.0 * portable::cos(phase(j, i));
      surface.set_glaze(j, i, 100 + static_cast<int>(std::floor(wave + 0.5)));
    }
  return surface;
}

/// What is left of such a wave far from the tube's ends, over what there was; both as shares of the
/// glaze that lies there, for all of it gives a little to the lip.
double share_left(const Melt& melt, const std::function<double(int, int)>& phase, int rows) {
  double wave = 0.0, all = 0.0;
  for (int j = 180 - rows / 2; j < 180 - rows / 2 + rows; ++j)
    for (int i = 0; i < kSectors; ++i) {
      wave += melt.glaze(j, i) * portable::cos(phase(j, i));
      all += melt.glaze(j, i);
    }
  return 2.0 * wave / all / 0.4;
}

TEST(Melt, ItLevelsByOrchardsLength) {
  Surface surface = made(tube());
  DipDef dip = whole_dip();
  dip.rate = 6e-4, dip.seconds = 1.0, dip.drinks = 1.0;
  done(surface, dip);
  MeltDef def;
  def.shrinks = 1.0;
  // 1000 Pa s, 0.6 mm, 30 min: waves of 16 mm keep 1 / e.
  EXPECT_NEAR(2.0 * portable::kPi * melted(surface, def).levels(), 0.0163, 2e-4);
  // The length grows with the thickness to the power of 3/4.
  MeltDef half = def;
  half.shrinks = 0.5;
  EXPECT_NEAR(melted(surface, half).levels() / melted(surface, def).levels(), std::pow(0.5, 0.75),
              1e-3);
}

TEST(Melt, AWaveRoundThePotKeepsWhatTheLawSays) {
  for (const int waves : {12, 28, 42}) {
    const auto phase = [&](int, int i) { return 2.0 * portable::kPi * waves * i / kSectors; };
    const Surface surface = rippled(phase);
    const Melt melt = melted(surface);
    const double k = waves / 0.045 * melt.levels();
    EXPECT_NEAR(share_left(melt, phase, 40), std::exp(-k * k * k * k), 0.012) << waves;
  }
}

TEST(Melt, AWaveAlongTheOutlineKeepsWhatTheLawSays) {
  for (const int length : {60, 32, 20}) {  // rows
    const auto phase = [&](int j, int) { return 2.0 * portable::kPi * j / length; };
    const Surface surface = rippled(phase);
    const Melt melt = melted(surface);
    const double k = 2.0 * portable::kPi / (length * 2.5e-4) * melt.levels();
    EXPECT_NEAR(share_left(melt, phase, 2 * length), std::exp(-k * k * k * k), 0.012) << length;
  }
}

TEST(Melt, ASlantingWaveIsLevelledLikeAStraightOne) {
  for (const int waves : {14, 28}) {
    const int length = 36;
    for (const int side : {1, -1}) {
      const auto phase = [&](int j, int i) {
        return 2.0 * portable::kPi * (1.0 * waves * i / kSectors + 1.0 * side * j / length);
      };
      const Surface surface = rippled(phase);
      const Melt melt = melted(surface);
      const double along = 2.0 * portable::kPi / (length * 2.5e-4), round = waves / 0.045;
      const double k = std::sqrt(along * along + round * round) * melt.levels();
      EXPECT_NEAR(share_left(melt, phase, 2 * length), std::exp(-k * k * k * k), 0.012) << waves;
    }
  }
}

TEST(Melt, LosesNoGlaze) {
  Surface surface = made(bowl());
  RandomStrokes random(11);
  for (int n = 0; n < 200; ++n) ASSERT_TRUE(apply(surface, random.next(surface)));
  done(surface, whole_dip());
  done(surface, WipeDef{}, straight(surface, {0.02, 0.0}, {0.05, 0.3}));
  for (const double seconds : {0.0, 600.0, 1e5}) {
    MeltDef def;
    def.seconds = seconds;
    EXPECT_EQ(melted(surface, def).volume(), surface.glaze_volume()) << seconds;
  }
}

TEST(Melt, WithoutTimeItIsTheRawGlaze) {
  Surface surface = made(bowl());
  done(surface, CutDef{}, straight(surface, {0.02, 0.0}, {0.04, 0.1}));
  done(surface, whole_dip());
  done(surface, WipeDef{}, straight(surface, {0.02, 0.0}, {0.05, 0.1}));
  MeltDef def;
  def.seconds = 0.0;
  const Melt melt = melted(surface, def);
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      ASSERT_NEAR(melt.glaze(j, i), surface.glaze(j, i) * kAsRaw, 1) << j << ' ' << i;
}

TEST(Melt, RidgesBesideAFingerRoundOver) {
  Surface surface = made(bowl());
  DipDef dip = whole_dip();
  dip.rate = 5e-4, dip.seconds = 1.0, dip.drinks = 1.0;
  done(surface, dip);
  WipeDef finger;
  finger.width = 0.007;
  done(surface, finger, straight(surface, {0.02, 0.0}, {0.05, 0.0}));
  const Melt melt = melted(surface);
  const int j = 140;
  int raw_step = 0, fired_step = 0, most = 0;
  for (int i = -60; i < 60; ++i) {
    const auto raw = [&](int at) { return surface.glaze(j, wrapped(at)) * kAsRaw; };
    const auto fired = [&](int at) { return melt.glaze(j, wrapped(at)); };
    raw_step = std::max(raw_step, std::abs(raw(i + 1) - raw(i)));
    fired_step = std::max(fired_step, std::abs(fired(i + 1) - fired(i)));
    most = std::max(most, fired(i));
  }
  EXPECT_GT(raw_step, 150 * kAsRaw);
  EXPECT_LT(fired_step, 20 * kAsRaw);
  EXPECT_LE(most, 200 * kAsRaw);
  // The wiped line can still be seen.
  EXPECT_LT(melt.glaze(j, 0), 60 * kAsRaw);
}

TEST(Melt, ASpikeOfGlazeSinks) {
  Surface surface = made(bowl());
  done(surface, whole_dip());
  const int j = 120, raw = surface.glaze(j, 0), spike = kMostGlaze;
  for (int up = 0; up < 4; ++up)
    for (int i = -3; i < 4; ++i) surface.set_glaze(j + up, wrapped(i), spike);
  const Melt melt = melted(surface);
  EXPECT_LT(melt.glaze(j, 0) - raw * kAsRaw, (spike - raw) * kAsRaw / 4);
}

TEST(Melt, ACarvedLineFillsAndABeadShowsThrough) {
  Surface surface = made(jar());
  CutDef cut;
  cut.width = 0.001, cut.depth = 5e-4, cut.section = CutDef::flat, cut.burr = 0.0;
  done(surface, cut, straight(surface, {0.05, 0.0}, {0.09, 0.0}));
  BrushDef trail;
  trail.width = 0.001, trail.thickness = 5e-4, trail.tracks = 1;
  done(surface, trail, straight(surface, {0.05, 0.2}, {0.09, 0.2}));
  DipDef dip = whole_dip();
  dip.seconds = 1.0;
  done(surface, dip);
  const Melt melt = melted(surface);
  const int j = 280, away = melt.glaze(j, 100);
  // 0.5 mm of melt is 1 mm of raw glaze.
  EXPECT_GT(melt.glaze(j, 0), away + 2500);
  EXPECT_LT(melt.glaze(j, 0), away + 4000);
  EXPECT_LT(melt.glaze(j, kSectors / 5), away / 2);
  EXPECT_GT(melt.glaze(j, kSectors / 5), 0);
  // Of the line's 500 um the top sinks by less than a third.
  EXPECT_NEAR(surface.relief(j, 0) * int{kNanometres} + melt.fired(j, 0), melt.fired(j, 100),
              166'000);
}

TEST(Melt, ItIsThinOnTheLipAndThickInTheCorner) {
  Surface surface = made({{{0.0, 0.045, 0.0}, {0.006, 0.045, 0.04}, {0.05, 0.045, 0.04}}});
  DipDef dip = whole_dip();
  dip.seconds = 1.0, dip.drinks = 1.0;
  done(surface, dip);
  const Melt melt = melted(surface);
  int lip = 0, corner = 0;
  for (int j = 0; j < surface.rows(); ++j) {
    if (surface.row(j).part == Part::outside) lip = j;
    if (surface.row(j).part == Part::inside) corner = j;
  }
  const int wall = melt.glaze(lip / 2, 0);
  EXPECT_LT(melt.glaze(lip, 0), 0.6 * wall);
  EXPECT_GT(melt.glaze(corner, 0), 1.5 * wall);
  EXPECT_NEAR(wall, 100 * kAsRaw, 100);
}

TEST(Melt, CrestsOfTheBodyKeepAFilm) {
  // Ridges that stand out as far as the raw coat is thick, and twice that.
  for (const double height : {4e-4, 8e-4}) {
    Surface surface = made(tube());
    for (int j = 0; j < surface.rows(); ++j)
      for (int i = 0; i < kSectors; ++i) {
        const double wave = 0.5 * height * 1e6 * portable::cos(2.0 * portable::kPi * j / 12.0);
        surface.set_relief(j, i, static_cast<int>(std::floor(wave + 0.5)));
      }
    MeltDef def;
    def.even = 4e-4;
    const Melt melt = melted(surface, def);
    // Half of the coat is the melt's thickness, so the level top lacks `lacks` coats over a crest.
    const double lacks = height / def.even;
    double film = 1.0;
    for (int n = 0; n < 10000; ++n) film -= 1e-4 * lacks * film * film * film;
    const double crest = melt.glaze(180, 0), trough = melt.glaze(186, 0);
    EXPECT_NEAR(crest / trough, film / (1.0 + lacks), 0.01) << height;
    EXPECT_GT(crest, 0.25 * 100 * kAsRaw);
  }
}

TEST(Melt, ABarePlaceStaysBareAndNoGlazeFlowsIntoIt) {
  Surface surface = made(jar());
  ResistDef wax;
  done(surface, wax, straight(surface, {0.08, 0.2}, {0.09, 0.2}));
  DipDef dip = whole_dip();
  dip.from = 0.02, dip.seconds = 1.0;
  done(surface, dip);
  const Melt melt = melted(surface);
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      ASSERT_EQ(melt.glaze(j, i) == 0, surface.glaze(j, i) == 0) << j << ' ' << i;
}

TEST(Melt, AnEvenCoatIsGivenWhereNoneWasLaid) {
  Surface surface = made(bowl());
  EXPECT_FALSE(melted(surface).glazed());
  EXPECT_EQ(melted(surface).volume(), 0);
  ResistDef wax;
  done(surface, wax, straight(surface, {0.03, 0.2}, {0.035, 0.2}));
  MeltDef def;
  def.even = 4e-4;
  const Melt melt = melted(surface, def);
  EXPECT_TRUE(melt.glazed());
  Volume coat = 0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      if (!surface.resist(j, i)) coat += Volume{surface.row(j).area} * 400'000;
  EXPECT_EQ(melt.volume(), coat);
  // It is not given to one who laid glaze.
  done(surface, whole_dip());
  EXPECT_EQ(melted(surface, def).volume(), surface.glaze_volume());
}

TEST(Melt, InManyPiecesItIsTheSame) {
  Surface surface = made(bowl());
  done(surface, CutDef{}, straight(surface, {0.02, 0.0}, {0.04, 0.1}));
  done(surface, whole_dip());
  const Melt at_once = melted(surface);
  Result<Melt> slow = Melt::begin(surface, {});
  ASSERT_TRUE(slow);
  int pieces = 0;
  while (!slow->go_on(20'000)) ++pieces;
  EXPECT_GT(pieces, 50);
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) ASSERT_EQ(slow->glaze(j, i), at_once.glaze(j, i));
}

TEST(Melt, TurnedByWholeSectorsIsTheMeltTurned) {
  Surface here = made(bowl()), there = made(bowl());
  const auto way = straight(here, {0.02, 0.0}, {0.05, 0.2});
  done(here, whole_dip()), done(there, whole_dip());
  ASSERT_TRUE(apply(here, {WipeDef{}, way, false}));
  ASSERT_TRUE(apply(there, turned({WipeDef{}, way, false}, 333)));
  const Melt a = melted(here), b = melted(there);
  for (int j = 0; j < here.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      // Rounding is carried from one sector to the next, and begins at sector 0.
      ASSERT_NEAR(a.glaze(j, i), b.glaze(j, wrapped(i + 333)), 1) << j << ' ' << i;
}

TEST(Melt, TheSameGlazeMeltsToTheSameBitsOnEveryMachine) {
  Surface surface = made(jar());
  RandomStrokes random(7);
  for (int n = 0; n < 100; ++n) ASSERT_TRUE(apply(surface, random.next(surface)));
  done(surface, whole_dip());
  done(surface, WipeDef{}, straight(surface, {0.02, 0.0}, {0.15, 0.3}));
  const Melt melt = melted(surface);
  StateHash hash;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) hash.add(std::uint64_t(melt.glaze(j, i)));
  EXPECT_EQ(hash.value(), kGolden);
}

TEST(Melt, AFigureOutOfItsRangeIsOneProblem) {
  const Surface surface = made(bowl());
  MeltDef def;
  def.viscosity = 1.0;
  const Result<Melt> melt = Melt::begin(surface, def);
  ASSERT_FALSE(melt);
  EXPECT_EQ(melt.error().where, "melt.viscosity");
}

}  // namespace
}  // namespace onggi::surface_test::melt_test
