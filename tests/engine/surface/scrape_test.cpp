#include "engine/surface/scrape.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::scrape_test {
namespace {

Stroke flat_groove(const Surface& surface) {
  CutDef def;
  def.section = CutDef::flat;
  def.width = 0.0015, def.depth = 0.0008;
  return {def, straight(surface, {0.020, 0.0}, {0.035, 0.1}), false};
}
BrushDef white() {
  BrushDef def;
  def.pigment = 1, def.fill = 0.67, def.width = 0.03, def.reach = 10.0;
  return def;
}
ScrapeDef wide() {
  ScrapeDef def;
  def.width = 0.03;
  return def;
}

TEST(Scrape, TwiceIsOnce) {
  Surface surface = made(bowl());
  ASSERT_TRUE(apply(surface, flat_groove(surface)));
  done(surface, white(), band(surface, 0.028, 10.0));
  done(surface, wide(), band(surface, 0.028));
  const std::uint64_t hash = surface.hash();
  const Work again = done(surface, wide(), band(surface, 0.028));
  EXPECT_EQ(again, Work{});
  EXPECT_EQ(surface.hash(), hash);
}

TEST(Scrape, InlayIsACutABrushAndAScrape) {
  Surface surface = made(bowl());
  ASSERT_TRUE(apply(surface, flat_groove(surface)));
  const Surface cut_only = surface;
  done(surface, white(), band(surface, 0.028, 10.0));
  done(surface, wide(), band(surface, 0.028));
  int inlaid = 0;
  for (int j = 60; j < 164; ++j) {  // within the blade
    for (int i = 0; i < kSectors; ++i) {
      if (cut_only.relief(j, i) < -100) {
        ASSERT_GT(surface.slip(j, i).thickness(), 400'000) << j << ' ' << i;
        ++inlaid;
      } else {
        ASSERT_EQ(surface.slip(j, i), Strata{}) << j << ' ' << i;
        ASSERT_EQ(surface.relief(j, i), -100) << j << ' ' << i;
      }
      ASSERT_LE(surface.top(j, i), -100'000);
    }
  }
  EXPECT_GT(inlaid, 500);
}

TEST(Scrape, ReverseInlayFillsTheGroundAndLeavesTheFigureBare) {
  Surface surface = made(bowl());
  CutDef ground;
  ground.section = CutDef::flat, ground.width = 0.01, ground.depth = 0.0006;
  done(surface, ground, straight(surface, {0.025, 0.0}, {0.025, 0.1}));
  done(surface, ground, straight(surface, {0.0375, 0.0}, {0.0375, 0.1}));  // 2.5 mm between stand
  done(surface, white(), straight(surface, {0.031, 0.0}, {0.031, 0.1}, 10.0));
  done(surface, wide(), straight(surface, {0.031, 0.0}, {0.031, 0.1}));
  EXPECT_EQ(surface.slip(125, 80), Strata{});
  EXPECT_GT(surface.slip(100, 80).thickness(), 300'000);
  EXPECT_GT(surface.slip(150, 80).thickness(), 300'000);
}

TEST(Scrape, TakesWhatItSaysAndNoMore) {
  Surface surface = made(bowl());
  done(surface, white(), band(surface, 0.028, 10.0));
  const Volume before = all_slip(surface);
  const Work work = done(surface, wide(), band(surface, 0.028));
  EXPECT_EQ(all_slip(surface), before - work.slip_taken);
  Volume clay = 0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      clay -= Volume{surface.relief(j, i)} * kNanometres * surface.row(j).area;
  EXPECT_EQ(clay, work.clay_taken);
}

TEST(Scrape, OutsideTheBladeNothingChanges) {
  Surface surface = made(bowl());
  done(surface, wide(), band(surface, 0.028));
  EXPECT_EQ(surface.relief(50, 100), 0);
  EXPECT_EQ(surface.relief(174, 100), 0);
  EXPECT_EQ(surface.relief(112, 100), -100);
}

}  // namespace
}  // namespace onggi::surface_test::scrape_test
