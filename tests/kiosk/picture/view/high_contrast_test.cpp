#include "kiosk/picture/view/high_contrast.h"

#include <gtest/gtest.h>

#include "kiosk/picture/view/palette.h"

namespace onggi::view::high_contrast_test {
namespace {

TEST(HighContrast, WordsAndGuideLinesHaveSevenToOneOnPlaster) {
  for (const Color c : {kInk, kFaintInk, kCobalt, kIron, kDeepCeladon}) {
    EXPECT_GE(contrast(in_high_contrast(c), kPlaster), 7.0);
    EXPECT_GT(contrast(in_high_contrast(c), kPlaster), contrast(c, kPlaster));
  }
}

TEST(HighContrast, WordsOnAFilledButtonHaveSevenToOne) {
  for (const Color c : {kCobalt, kHeldCobalt})
    EXPECT_GE(contrast(in_high_contrast(kPlaster), in_high_contrast(c)), 7.0);
}

TEST(HighContrast, AGlazeKeepsItsColour) {
  for (const Color c : {kCeladon, kDryClay}) EXPECT_EQ(in_high_contrast(c), c);
}

TEST(HighContrast, LinesGrowHeavierAndTheirHalosSolidAndNothingMoves) {
  const Rect at{10, 20, 30, 40};
  std::vector<Item> items{Text{at, "clay", {}, with_alpha(kInk, 0.5f)},
                          Box{at, 3, with_alpha(kCobalt, 0.1f), 2, kCobalt},
                          Line{{{0, 0}, {9, 9}}, {with_alpha(kPlaster, 0.6f)}, 4}};
  to_high_contrast(items);
  EXPECT_EQ(std::get<Text>(items[0]).box, at);
  EXPECT_EQ(std::get<Text>(items[0]).color.a, 0.5f);
  EXPECT_EQ(std::get<Box>(items[1]).rect, at);
  EXPECT_EQ(std::get<Box>(items[1]).fill.a, 0.1f);
  EXPECT_GT(std::get<Box>(items[1]).border, 2);
  EXPECT_GT(std::get<Line>(items[2]).width, 4);
  EXPECT_EQ(std::get<Line>(items[2]).colors[0].a, 1);
}

}  // namespace
}  // namespace onggi::view::high_contrast_test
