#include "kiosk/visit/decorating/decorated_pot.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/decorating/a_jar.h"

namespace onggi::decorating {
namespace {

using decoration::CoatPicture;
using decoration::Way;
using decoration::WayTool;
using surface::kSectors;

enum Of { band, leaf, cut, flood, scrape, glaze, wipe, smoke };

WayTool tool(const char* id, WayTool::Hand hand, surface::Tool law, int repeats = 8) {
  WayTool tool;
  tool.id = id, tool.hand = hand, tool.law = std::move(law), tool.repeats = repeats;
  return tool;
}

/// One of every kind, in the order of `Of`.
Way every_tool() {
  Way way;
  way.palette.pigments = {{{0.9f, 0.9f, 0.9f}, {0.8f, 0.8f, 0.8f}, 2e-5},
                          {{0.4f, 0.1f, 0.1f}, {0.02f, 0.02f, 0.02f}, 2e-5}};
  way.pigments = {{"white", {}}, {"black", {}}};
  way.figures = {{"leaf", {{{{-0.3, -0.5}, {0.3, -0.5}, {0.3, 0.5}, {-0.3, 0.5}}}, {}}, {}}};
  surface::BrushDef brush;
  brush.width = 0.006, brush.reach = 100.0;
  way.tools.push_back(tool("band", WayTool::ring, brush));
  way.tools.back().pigments = {0, 1};
  way.tools.push_back(tool("leaf", WayTool::figure, brush, 5));
  way.tools.back().pigments = {1, 0};
  way.tools.back().motifs = {0};
  surface::CutDef needle;
  needle.width = 0.001, needle.depth = 7e-4, needle.burr = 0.0;
  way.tools.push_back(tool("cut", WayTool::line, needle));
  surface::BrushDef broad = brush;
  broad.width = 0.03, broad.fill = 0.67;
  way.tools.push_back(tool("flood", WayTool::all, broad));
  way.tools.back().pigments = {0};
  surface::ScrapeDef blade;
  blade.width = 0.02;
  way.tools.push_back(tool("scrape", WayTool::ring, blade));
  way.tools.back().needs = flood;
  surface::DipDef dip;
  dip.seconds = 1.0, dip.drinks = 1.0;
  way.tools.push_back(tool("glaze", WayTool::all, dip));
  surface::WipeDef finger;
  finger.wet_time = 3600.0;
  way.tools.push_back(tool("wipe", WayTool::line, finger));
  way.tools.back().needs = glaze;
  way.tools.push_back(tool("smoke", WayTool::up, surface::SmokeDef{}));
  return way;
}

struct Decorating : testing::Test {
  Way way = every_tool();
  std::unique_ptr<DecoratedPot> pot = *DecoratedPot::begin(a_jar(), way);

  void touch(int tool, double along, double turns = 0.3) {
    pot->choose_tool(tool);
    pot->press({along, turns});
    pot->lift();
    pot->finish();
  }
  int slip(double along, double turns) const {
    return pot->surface()
        .slip(static_cast<int>(along * 4000), static_cast<int>(turns * kSectors))
        .thickness();
  }
  CoatPicture::Texel texel(double along, double turns) const {
    return pot->picture().paint()[static_cast<std::size_t>(along * 4000) * kSectors +
                                  static_cast<std::size_t>(turns * kSectors)];
  }
  /// The picture that a fresh look at the surface gives.
  void expect_whole_picture() {
    pot->finish();
    CoatPicture whole(pot->surface(), way.palette);
    whole.touch_all();
    whole.draw(pot->surface(), 1 << 20);
    EXPECT_TRUE(whole.paint() == pot->picture().paint());
    EXPECT_TRUE(whole.form() == pot->picture().form());
  }
};

TEST_F(Decorating, AFingerThatOnlyTouchedLeavesABandAllRound) {
  touch(band, 0.08);
  for (int i = 0; i < kSectors; ++i)
    ASSERT_GT(pot->surface().slip(320, i).thickness(), 50'000) << i;
  EXPECT_EQ(slip(0.06, 0.5), 0);
  expect_whole_picture();
}

TEST_F(Decorating, ABandGoesOnByItselfAndThenTheHandMayWorkAgain) {
  pot->choose_tool(band);
  pot->press({0.08, 0.3});
  EXPECT_TRUE(pot->turns());
  pot->lift();
  EXPECT_TRUE(pot->busy());
  pot->press({0.12, 0.3});
  EXPECT_FALSE(pot->pressed());
  for (int frame = 0; frame < 90 && pot->busy(); ++frame) pot->update(1.0 / 30);
  EXPECT_FALSE(pot->busy());
  EXPECT_EQ(slip(0.12, 0.3), 0);
  pot->press({0.12, 0.3});
  EXPECT_TRUE(pot->pressed());
}

TEST_F(Decorating, ALineIsDrawnAsOftenAsChosenWhileTheFingerMoves) {
  pot->choose_tool(cut);
  pot->press({0.05, 0.0});
  for (int n = 1; n <= 20; ++n) pot->move({0.05 + 0.001 * n, 0.002 * n});
  const auto deep = [&](double along, double turns) {
    return pot->surface().relief(static_cast<int>(along * 4000),
                                 static_cast<int>((turns - std::floor(turns)) * kSectors)) < -200;
  };
  for (int k = 0; k < 8; ++k) EXPECT_TRUE(deep(0.06, 0.02 + k / 8.0)) << k;
  EXPECT_FALSE(deep(0.06, 0.02 + 1 / 16.0));
  pot->lift();
  expect_whole_picture();
  ASSERT_EQ(pot->did().size(), 1u);
  EXPECT_EQ(pot->did()[0].times, 1);
}

TEST_F(Decorating, ATapWithALineToolLeavesADabAsOftenAsChosen) {
  for (const int tool : {int{cut}, int{wipe}}) {
    if (tool == wipe) touch(glaze, 0.08);
    const std::uint64_t before = pot->surface().hash();
    pot->choose_tool(tool);
    pot->press({0.08, 0.1});
    pot->lift();
    EXPECT_NE(pot->surface().hash(), before) << tool;
  }
  EXPECT_LT(pot->surface().relief(324, kSectors / 10 + kSectors / 8), -200);
}

TEST_F(Decorating, AFigureIsCarriedByTheFingerAndStandsWhereItLifts) {
  pot->choose_tool(leaf);
  pot->choose_repeats(5);
  pot->press({0.05, 0.1});
  EXPECT_GT(slip(0.05, 0.1), 0);
  pot->move({0.1, 0.15});
  EXPECT_EQ(slip(0.05, 0.1), 0);
  for (int k = 0; k < 5; ++k) EXPECT_GT(slip(0.1, 0.15 + k / 5.0 - (k == 5)), 0) << k;
  EXPECT_EQ(slip(0.1, 0.25), 0);
  pot->lift();
  EXPECT_EQ(pot->did()[0].times, 1);
  expect_whole_picture();
}

TEST_F(Decorating, WhereThePotIsNarrowFiguresAreSmallerSoThatTheyDoNotOverlap) {
  way.tools[leaf].size = 0.1;
  pot->choose_tool(leaf);
  for (const int repeats : {5, 12}) {
    pot->choose_repeats(repeats);
    pot->put({0.08, 0.1});
    int bare = 0;
    for (int i = 0; i < kSectors / repeats; ++i) bare += pot->surface().slip(320, i).word() == 0;
    EXPECT_GT(bare, kSectors / repeats / 50) << repeats;
    pot->undo();
  }
}

TEST_F(Decorating, CutFloodedAndScrapedTheSlipStaysInTheCuts) {
  pot->choose_tool(cut);
  pot->press({0.05, 0.0});
  pot->move({0.1, 0.0});
  pot->lift();
  touch(flood, 0.05);
  EXPECT_GT(slip(0.08, 0.06), 0);
  for (double at = 0.04; at < 0.12; at += 0.015) touch(scrape, at);
  EXPECT_EQ(slip(0.08, 0.06), 0);
  EXPECT_GT(slip(0.08, 0.125), 200'000);
  EXPECT_GT(texel(0.08, 0.125)[3], 200);
  expect_whole_picture();
}

TEST_F(Decorating, AToolThatNeedsAnotherOneWaitsForItAndUndoTakesThatBack) {
  pot->choose_tool(wipe);
  EXPECT_TRUE(pot->waits(wipe));
  pot->press({0.08, 0.0});
  EXPECT_FALSE(pot->pressed());
  touch(glaze, 0.08);
  EXPECT_FALSE(pot->waits(wipe));
  pot->undo();
  EXPECT_TRUE(pot->waits(wipe));
  EXPECT_TRUE(pot->bare());
}

TEST_F(Decorating, AFingerInWetGlazeLeavesTheBodyBareBetweenTwoRidges) {
  touch(glaze, 0.08);
  const int even = pot->surface().glaze(320, 100);
  pot->choose_tool(wipe);
  pot->press({0.05, 0.5});
  pot->move({0.11, 0.5});
  pot->lift();
  EXPECT_LT(pot->surface().glaze(320, kSectors / 2), even / 4);
  int most = 0;
  for (int i = 0; i < kSectors / 8; ++i)
    most = std::max(most, pot->surface().glaze(320, kSectors / 2 + i));
  EXPECT_GT(most, even);
  expect_whole_picture();
}

TEST_F(Decorating, UndoTakesOneTouchBackHoweverManyPiecesItHad) {
  const std::uint64_t bare = pot->surface().hash();
  touch(band, 0.05);
  const std::uint64_t banded = pot->surface().hash();
  touch(flood, 0.05);
  touch(leaf, 0.1);
  touch(smoke, 0.12);
  pot->undo();
  pot->undo();
  pot->undo();
  EXPECT_EQ(pot->surface().hash(), banded);
  expect_whole_picture();
  pot->undo();
  EXPECT_EQ(pot->surface().hash(), bare);
  EXPECT_FALSE(pot->can_undo());
  EXPECT_TRUE(pot->did().empty());
}

// A flood changes more than the surface remembers to take back.
TEST_F(Decorating, WhatCannotBeTakenBackAnyMoreIsStillThere) {
  touch(band, 0.05);
  pot->choose_tool(smoke);
  for (int n = 0; n < 70; ++n) pot->put({0.15 - 0.001 * n, 0.3});
  while (pot->can_undo()) pot->undo();
  EXPECT_GT(slip(0.05, 0.3), 0);
  EXPECT_FALSE(pot->bare());
  EXPECT_EQ(pot->did().front().tool, int{band});
}

TEST_F(Decorating, AnotherToolTakenWhileAFingerIsOnThePotEndsItsStroke) {
  pot->choose_tool(leaf);
  pot->press({0.06, 0.1});
  pot->choose_tool(cut);
  EXPECT_FALSE(pot->pressed());
  pot->move({0.09, 0.2});
  pot->choose_tool(flood);
  pot->press({0.05, 0.1});
  pot->choose_tool(scrape);
  pot->finish();
  EXPECT_EQ(pot->did().back().tool, int{flood});
  EXPECT_FALSE(pot->waits(scrape));
}

TEST_F(Decorating, UndoUnderAFingerEndsItsStroke) {
  const std::uint64_t bare = pot->surface().hash();
  pot->choose_tool(cut);
  pot->press({0.05, 0.1});
  pot->move({0.07, 0.1});
  pot->undo();
  pot->move({0.1, 0.2});
  pot->lift();
  EXPECT_EQ(pot->surface().hash(), bare);
  expect_whole_picture();
}

TEST_F(Decorating, ByAButtonEachToolDoesItsWorkAtTheMark) {
  for (int tool = 0; tool < static_cast<int>(way.tools.size()); ++tool) {
    const std::uint64_t before = pot->surface().hash();
    pot->choose_tool(tool);
    pot->put({0.09, 0.25});
    pot->finish();
    EXPECT_NE(pot->surface().hash(), before) << way.tools[static_cast<std::size_t>(tool)].id;
  }
  EXPECT_EQ(pot->did().size(), way.tools.size());
  expect_whole_picture();
}

TEST_F(Decorating, AtTheEndsOfThePotNothingBreaks) {
  const double end = 1e-6 * pot->surface().rows() * surface::kRowHeight;
  for (int tool = 0; tool < static_cast<int>(way.tools.size()); ++tool)
    for (const double along : {0.0, end}) {
      pot->choose_tool(tool);
      pot->put({along, 0.999});
      pot->press({along, 0.0});
      pot->move({end - along, 0.4});
      pot->move({along, 0.9});
      pot->lift();
      pot->finish();
    }
  expect_whole_picture();
}

TEST_F(Decorating, TheChosenPigmentIsLaidAndTheFireShowsItsOtherColour) {
  pot->choose_tool(band);
  pot->choose_pigment(1);
  touch(band, 0.08);
  EXPECT_EQ(pot->surface().slip(320, 0).at(0).pigment, 1);
  const auto raw = texel(0.08, 0.5);
  pot->fire(true);
  pot->finish();
  EXPECT_LT(texel(0.08, 0.5)[0], raw[0] / 2);
}

}  // namespace
}  // namespace onggi::decorating
