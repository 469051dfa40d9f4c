#include "kiosk/visit/decorating/firing.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/decorating/decorating.h"

namespace onggi::decorating::firing_test {
namespace {

using decoration::CoatPicture;
using surface::kSectors;

TEST_F(Decorating, WaxIsSeenUntilTheFireAndKeepsGlazeAway) {
  way.tools.push_back(a_tool("wax", decoration::WayTool::line, surface::ResistDef{}, 5));
  pot = *DecoratedPot::begin(a_jar(), way);
  touch(smoke + 1, 0.08, 0.3);
  EXPECT_GT(texel(0.081, 0.3)[3], 100);
  touch(glaze, 0.08);
  EXPECT_EQ(pot->surface().glaze(324, static_cast<int>(0.3 * kSectors)), 0);
  EXPECT_GT(pot->surface().glaze(324, static_cast<int>(0.4 * kSectors)), 0);
  pot->fire(true);
  pot->finish();
  EXPECT_EQ(texel(0.081, 0.3)[3], 0);
  EXPECT_EQ(pot->picture().form()[324 * kSectors + static_cast<std::size_t>(0.3 * kSectors)][3], 0);
}

TEST_F(Decorating, InTheKilnWipedRidgesRoundOverAndNoFrameWaitsForIt) {
  touch(glaze, 0.08);
  touch(wipe, 0.08, 0.1);
  const auto steepest = [&] {
    int most = 0;
    for (const CoatPicture::Texel& texel : pot->picture().form())
      most = std::max(most, std::abs(texel[1] - 128));
    return most;
  };
  EXPECT_GT(steepest(), 40);
  pot->heat();
  int frames = 0;
  for (; frames < 400 && !pot->picture().melted(); ++frames) {
    pot->fire(frames > 10);
    pot->update(1.0 / 30);
  }
  EXPECT_GT(frames, 20);
  EXPECT_LT(frames, 150);
  EXPECT_LT(steepest(), 25);
  // Back on the wheel it is raw again, and can be wiped.
  pot->fire(false);
  pot->finish();
  EXPECT_FALSE(pot->picture().melted());
  EXPECT_GT(steepest(), 40);
  touch(wipe, 0.1, 0.2);
  expect_whole_picture();
}

// Pots on the wheel stand for larger ones, and what is drawn on them is as much smaller.
TEST_F(Decorating, WhatAFingerWipedStaysClearAndTheGlazeIsAsBeforeThreeMillimetresFromIt) {
  touch(glaze, 0.08);
  touch(wipe, 0.08, 0.1);
  pot->fire(true);
  pot->finish();
  const auto coat = [&](double along) {
    return pot->picture().form()[static_cast<std::size_t>(along * 4000) * kSectors +
                                 static_cast<std::size_t>(0.1 * kSectors)][3];
  };
  int least = 255;
  for (int n = -40; n <= 40; ++n) {
    const double apart = 0.0005 * n;
    if (std::abs(apart) >= 0.0029) {
      EXPECT_NEAR(coat(0.08 + apart), 100, 10) << apart;
    }
    least = std::min<int>(least, coat(0.08 + apart));
  }
  EXPECT_LT(least, 20);
}

TEST_F(Decorating, AFiredPotThatGoesHomeHasMelted) {
  touch(cut, 0.08);
  pot->fire(true);
  pot->finish();
  EXPECT_TRUE(pot->picture().melted());
  // A kiln without glaze leaves the cut as sharp as it is.
  const auto soft = pot->picture().form();
  pot->fire(true, false);
  pot->finish();
  EXPECT_FALSE(pot->picture().melted());
  EXPECT_NE(soft, pot->picture().form());
}

TEST_F(Decorating, APotIsSettledOnceTheMeltAndThePictureAreDoneAndNotBefore) {
  touch(cut, 0.08);
  pot->heat();
  pot->fire(true);
  pot->update(0.0);
  EXPECT_FALSE(pot->settled()) << "the melt has begun";
  int frames = 1;
  for (; frames < 400 && !pot->settled(); ++frames) pot->update(0.0);
  EXPECT_GT(frames, 20);
  EXPECT_LT(frames, 250);
  const auto form = pot->picture().form();
  pot->finish();
  EXPECT_TRUE(form == pot->picture().form()) << "nothing was left";
  pot->press({0.05, 0.1});
  EXPECT_FALSE(pot->settled());
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
}  // namespace onggi::decorating::firing_test
