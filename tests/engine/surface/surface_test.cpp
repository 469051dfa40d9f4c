#include "engine/surface/surface.h"

#include <gtest/gtest.h>

#include "engine/math/random.h"
#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test {
namespace {

TEST(Surface, IsBornBare) {
  Surface surface = made(bowl());
  EXPECT_FALSE(surface.can_undo());
  EXPECT_EQ(surface.undo_bytes(), 0u);
  EXPECT_EQ(all_slip(surface), 0);
  EXPECT_EQ(surface.glaze_volume(), 0);
  EXPECT_EQ(surface.top(5, 5), 0);
  const std::uint64_t hash = surface.hash();
  surface.undo();
  EXPECT_EQ(surface.hash(), hash);
  EXPECT_EQ(made(bowl()).hash(), hash);
  EXPECT_NE(made(jar()).hash(), hash);
}

TEST(Surface, ACellHoldsItsRangeAndNoMore) {
  Surface surface = made(bowl());
  surface.set_relief(3, 4, 99999), surface.set_glaze(3, 4, 300), surface.set_smoke(3, 4, 999);
  surface.set_burnish(3, 4, 9), surface.set_resist(3, 4, true);
  EXPECT_EQ(surface.relief(3, 4), kMostRelief);
  EXPECT_EQ(surface.glaze(3, 4), kMostGlaze);
  EXPECT_EQ(surface.smoke(3, 4), kMostSmoke);
  EXPECT_EQ(surface.burnish(3, 4), kMostBurnish);
  EXPECT_TRUE(surface.resist(3, 4));
  surface.set_relief(3, 4, -99999), surface.set_glaze(3, 4, -1), surface.set_smoke(3, 4, -1);
  surface.set_burnish(3, 4, -1), surface.set_resist(3, 4, false);
  EXPECT_EQ(surface.relief(3, 4), kLeastRelief);
  EXPECT_EQ(surface.glaze(3, 4), 0);
  EXPECT_EQ(surface.smoke(3, 4), 0);
  EXPECT_EQ(surface.burnish(3, 4), 0);
  EXPECT_FALSE(surface.resist(3, 4));
}

TEST(Surface, TheTopIsClayAndSlipAndGlaze) {
  Surface surface = made(bowl());
  surface.set_relief(1, 2, -100), surface.set_glaze(1, 2, 10);
  Strata strata;
  strata.set(0, {5, 1});
  surface.set_slip(1, 2, strata);
  EXPECT_EQ(surface.top(1, 2), -100'000 + 4000 + 40'000);
}

TEST(Surface, StrokesComeBackToTheBitAndAContinuedOneWithTheFirst) {
  Surface surface = made(bowl());
  const std::uint64_t bare = surface.hash();
  BrushDef brush;
  done(surface, brush, band(surface, 0.02));
  const std::uint64_t banded = surface.hash();
  const auto way = straight(surface, {0.01, 0.1}, {0.04, 0.2});
  ASSERT_TRUE(apply(surface, {CutDef{}, way, false}));
  ASSERT_TRUE(apply(surface, {ScrapeDef{}, band(surface, 0.02), true}));
  EXPECT_NE(surface.hash(), banded);
  EXPECT_EQ(surface.steps(), 2);
  surface.undo();
  EXPECT_EQ(surface.hash(), banded);
  surface.undo();
  EXPECT_EQ(surface.hash(), bare);
  EXPECT_FALSE(surface.can_undo());
}

TEST(Surface, UndoForgetsTheOldestAndKeepsWithinItsMemory) {
  Surface surface = made(jar());
  BrushDef brush;
  brush.width = 0.04;
  for (int n = 0; n < Surface::kMostSteps + 5; ++n) {
    brush.pigment = n % kPigments;
    done(surface, brush, straight(surface, {0.05, n * 0.01}, {0.06, n * 0.01}));
    // One step may be what is under way.
    ASSERT_LE(surface.undo_bytes(), Surface::kUndoBytes + (4u << 20));
  }
  EXPECT_LE(surface.steps(), Surface::kMostSteps);
  EXPECT_GT(surface.steps(), 3);
}

TEST(Surface, AUsualVisitFitsInTwelveMegabytesAndTheWorstInThirtyTwo) {
  Surface surface = made(jar());
  const std::size_t bare = surface.bytes();
  // A band, five motifs, a flood and a scrape over the belly, a dip.
  BrushDef brush;
  brush.reach = 10.0;
  done(surface, brush, band(surface, 0.03));
  const auto motif = *repeated({CutDef{}, straight(surface, {0.06, 0.0}, {0.08, 0.1}), false}, 5);
  for (const Stroke& stroke : motif) ASSERT_TRUE(apply(surface, stroke));
  brush.width = 0.04, brush.pigment = 1, brush.fill = 0.67;
  done(surface, brush, band(surface, 0.07, 10.0));
  ScrapeDef scrape;
  scrape.width = 0.04;
  done(surface, scrape, band(surface, 0.07));
  done(surface, whole_dip());
  // The figures of engine/docs/surface.md. The goal is 12 MB.
  EXPECT_LT(static_cast<double>(bare), 0.25e6);
  EXPECT_LT(static_cast<double>(surface.bytes()), 2.25e6);
  EXPECT_LT(static_cast<double>(surface.undo_bytes()), 1.85e6);
  // Every cell its own.
  Random random(1);
  for (int j = 0; j < surface.rows(); ++j) {
    for (int i = 0; i < kSectors; ++i) {
      const auto bits = static_cast<std::uint32_t>(random.bits());
      surface.set_relief(j, i, static_cast<int>(bits % 100)),
          surface.set_slip(j, i, Strata(bits & 63u));
      surface.set_glaze(j, i, static_cast<int>(bits % 200)),
          surface.set_smoke(j, i, static_cast<int>(bits % 256));
      surface.set_burnish(j, i, static_cast<int>(bits % 4));
    }
  }
  EXPECT_EQ(surface.rows(), 1864);
  EXPECT_LT(static_cast<double>(surface.bytes()), 29.35e6);  // the goal is 32 MB
}

}  // namespace
}  // namespace onggi::surface_test
