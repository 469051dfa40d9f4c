#include "kiosk/visit/decorating/decorated_pot.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/decorating/decorating.h"

namespace onggi::decorating::decorated_pot_test {
namespace {

using decoration::CoatPicture;
using decoration::Way;
using surface::kSectors;

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

TEST_F(Decorating, AShakingFingerDrawsACalmLine) {
  pot->choose_tool(cut);
  pot->press({0.05, 0.5});
  for (int n = 1; n <= 200; ++n)
    pot->move({0.05 + 0.0003 * n, 0.5 + (n % 2 == 0 ? 0.0025 : -0.0025)});
  pot->lift();
  // The finger went 1 mm to either side; nothing is cut beyond 1 mm, but for the needle's width.
  for (int row = 220; row < 400; ++row) {
    EXPECT_EQ(pot->surface().relief(row, kSectors / 2 + 7), 0) << row;
    EXPECT_EQ(pot->surface().relief(row, kSectors / 2 - 7), 0) << row;
  }
}

TEST_F(Decorating, AQuickFingersLineHasNoCorners) {
  pot->choose_tool(cut);
  pot->press({0.05, 0.5});
  pot->move({0.09, 0.5});
  pot->move({0.09, 0.6});
  pot->lift();
  const auto cut_at = [&](double along, double turns) {
    return pot->surface().relief(static_cast<int>(along * 4000),
                                 static_cast<int>(turns * kSectors)) < -200;
  };
  EXPECT_FALSE(cut_at(0.0895, 0.5));
  EXPECT_TRUE(cut_at(0.06, 0.5));
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

TEST_F(Decorating, AFloodLeavesNoRowOfTheOutsideBare) {
  touch(flood, 0.05);
  for (double along = 0.001; along < pot->outside() - 0.001; along += 0.00025)
    ASSERT_GT(slip(along, 0.4), 0) << along;
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

// Else a visitor who flooded four times would undo three times and see nothing.
TEST_F(Decorating, WhatChangesNothingIsNoStepAndCostsNoUndo) {
  touch(band, 0.05);
  const std::uint64_t banded = pot->surface().hash();
  for (int n = 0; n < 4; ++n) touch(flood, 0.05);
  EXPECT_EQ(pot->did().back().times, 1);
  pot->undo();
  EXPECT_EQ(pot->surface().hash(), banded);
  for (int n = 0; n < 4; ++n) touch(glaze, 0.05);
  pot->undo();
  EXPECT_EQ(pot->surface().hash(), banded);
  touch(flood, 0.05);
  touch(scrape, 0.12);
  const std::uint64_t scraped = pot->surface().hash();
  touch(scrape, 0.12);
  EXPECT_EQ(pot->surface().hash(), scraped);
  EXPECT_EQ(pot->did().back().times, 1) << "the blade meets nothing any more";
  touch(flood, 0.05);
  EXPECT_NE(pot->surface().hash(), scraped) << "what was scraped is flooded again";
  EXPECT_EQ(pot->did()[1].times, 2);
  pot->undo();
  pot->undo();
  pot->undo();
  EXPECT_EQ(pot->surface().hash(), banded);
  expect_whole_picture();
}

TEST_F(Decorating, AnotherColourCoversAllAgain) {
  way.tools[flood].pigments = {0, 1};
  touch(flood, 0.05);
  pot->choose_pigment(1);
  touch(flood, 0.05);
  touch(flood, 0.05);
  ASSERT_EQ(pot->did().size(), 1u);
  EXPECT_EQ(pot->did()[0].times, 2);
}

TEST_F(Decorating, HowManyIsTheToolsOwnUntilTheVisitorChoosesItForAll) {
  pot->choose_tool(leaf);
  EXPECT_EQ(pot->repeats(), 5);
  pot->choose_tool(cut);
  EXPECT_EQ(pot->repeats(), 8);
  pot->choose_repeats(12);
  EXPECT_EQ(pot->repeats(), 12);
  pot->choose_tool(leaf);
  EXPECT_EQ(pot->repeats(), 12);
  pot->choose_tool(wipe);
  EXPECT_EQ(pot->repeats(), 12);
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

TEST_F(Decorating, ABrushSmearsSlipThatIsStillWet) {
  const auto crossed = [&](double waited) {
    pot = *DecoratedPot::begin(a_jar(), way);
    pot->choose_tool(band);
    pot->choose_pigment(0);
    touch(band, 0.08);
    pot->update(waited);
    pot->choose_pigment(1);
    touch(band, 0.084);
    return pot->surface().hash();
  };
  const std::uint64_t dry = crossed(20.0);
  EXPECT_EQ(crossed(40.0), dry);
  EXPECT_NE(crossed(0.5), dry);
}

TEST_F(Decorating, AStampIsPressedUprightRoundThePot) {
  surface::StampDef stamp;
  stamp.side = decoration::kStampSide, stamp.depth = 6e-4;
  way.tools.push_back(a_tool("stamp", decoration::WayTool::figure, stamp, 5));
  way.tools.back().motifs = {0};
  way.tools.back().size = 0.01;
  pot = *DecoratedPot::begin(a_jar(), way);
  touch(smoke + 1, 0.08, 0.3);
  const int middle = static_cast<int>(0.3 * kSectors);
  for (int k = 0; k < 5; ++k)
    EXPECT_LT(pot->surface().relief(320, surface::wrapped(middle + k * kSectors / 5)), -300) << k;
  // The leaf is 6 mm wide and 10 mm high.
  const int width = pot->surface().row(320).width;
  const auto deep = [&](int j, double mm) {
    return pot->surface().relief(j, middle + static_cast<int>(mm * 1e6 / width)) < -300;
  };
  EXPECT_TRUE(deep(320 + 17, 0.0));
  EXPECT_FALSE(deep(320 + 23, 0.0));
  EXPECT_TRUE(deep(320, 2.5));
  EXPECT_FALSE(deep(320, 3.5));
  expect_whole_picture();
}

TEST_F(Decorating, ABrushThatEmptiesLeavesNothingAtTheEndOfItsWayAndIsDippedForTheNext) {
  surface::BrushDef brush;
  brush.width = 0.004, brush.reach = 0.03;
  way.tools.push_back(a_tool("free", decoration::WayTool::line, brush, 5));
  way.tools.back().pigments = {0};
  pot = *DecoratedPot::begin(a_jar(), way);
  pot->choose_tool(smoke + 1);
  for (const double turns : {0.1, 0.15}) {
    pot->press({0.04, turns});
    for (int n = 1; n <= 50; ++n) pot->move({0.04 + 0.001 * n, turns});
    pot->lift();
    EXPECT_GT(slip(0.045, turns), 50'000);
    EXPECT_EQ(slip(0.08, turns), 0);
  }
}

TEST_F(Decorating, TheClayComesAsFarAsTheToolsThatWereUsedNeedAndUndoBringsItBack) {
  way.tools[cut].state = decoration::WayTool::leather;
  way.tools[band].state = decoration::WayTool::dry;
  EXPECT_EQ(pot->state(), decoration::WayTool::soft);
  touch(cut, 0.08);
  EXPECT_EQ(pot->state(), decoration::WayTool::leather);
  touch(band, 0.08);
  EXPECT_EQ(pot->state(), decoration::WayTool::dry);
  touch(cut, 0.05);  // it stays dry
  EXPECT_EQ(pot->state(), decoration::WayTool::dry);
  pot->undo();
  pot->undo();
  EXPECT_EQ(pot->state(), decoration::WayTool::leather);
}

TEST_F(Decorating, AZoneIsTouchedByWhatLiesInItAndNotByACover) {
  touch(flood, 0.08);
  touch(smoke, 0.02);
  EXPECT_FALSE(pot->touched(0.0, 0.16));
  touch(cut, 0.08);
  EXPECT_TRUE(pot->touched(0.07, 0.09));
  EXPECT_FALSE(pot->touched(0.12, 0.14));
  pot->undo();
  EXPECT_FALSE(pot->touched(0.07, 0.09));
}

}  // namespace
}  // namespace onggi::decorating::decorated_pot_test
