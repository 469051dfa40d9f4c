#include "kiosk/picture/view/recolor.h"

#include <gtest/gtest.h>

#include "kiosk/picture/view/palette.h"

namespace onggi::view::recolor_test {
namespace {

constexpr std::pair<Color, Color> kTurned[] = {{kInk, kPlaster}, {kPlaster, kInk}};

TEST(Recolor, WhatStandsInAnothersPlaceIsNotReplacedInItsTurn) {
  EXPECT_EQ(recolored(kInk, kTurned), kPlaster);
  EXPECT_EQ(recolored(kPlaster, kTurned), kInk);
}

TEST(Recolor, OpacityIsKeptAndSoIsAColourThatIsNotAmongThem) {
  EXPECT_EQ(recolored(with_alpha(kInk, 0.3f), kTurned), with_alpha(kPlaster, 0.3f));
  EXPECT_EQ(recolored(kIron, kTurned), kIron);
}

TEST(Recolor, ReachesWordsFillingsBordersAndEveryPointOfALineAndNothingElseChanges) {
  const Rect at{1, 2, 3, 4};
  std::vector<Item> items{Text{at, "clay", {}, kInk}, Box{at, 5, kInk, 6, kPlaster},
                          Line{{{0, 0}, {9, 9}}, {kInk, kIron, kPlaster}, 7}, Picture{at, 8, 0.5f}};
  recolor(items, kTurned);
  EXPECT_EQ(items, (std::vector<Item>{Text{at, "clay", {}, kPlaster}, Box{at, 5, kPlaster, 6, kInk},
                                      Line{{{0, 0}, {9, 9}}, {kPlaster, kIron, kInk}, 7},
                                      Picture{at, 8, 0.5f}}));
}

}  // namespace
}  // namespace onggi::view::recolor_test
