#include "kiosk/picture/view/dark.h"

#include <gtest/gtest.h>

#include "kiosk/picture/view/palette.h"

namespace onggi::view::dark_test {
namespace {

TEST(Dark, WordsAreSevenToOneOnItAndWhatCanBeTouchedIsFourAndAHalf) {
  for (const Color words : {kInk, kFaintInk}) EXPECT_GE(contrast(in_the_dark(words), kDark), 7.0);
  for (const Color accent : {kCobalt, kHeldCobalt, kIron, kDeepCeladon})
    EXPECT_GE(contrast(in_the_dark(accent), kDark), 4.5);
  // A button that is filled has the wall's colour for its words.
  EXPECT_GE(contrast(in_the_dark(kPlaster), in_the_dark(kCobalt)), 4.5);
  EXPECT_GE(contrast(in_the_dark(kPlaster), in_the_dark(kHeldCobalt)), 4.5);
  EXPECT_LE(luminance(kDark), 0.01);
}

TEST(Dark, LiesBelowAllAndKeepsPlacesOpacityAndOtherColours) {
  const Color glaze = rgb(0x123456, 0.5f);
  std::vector<Item> items{Text{}, Box{{1, 2, 3, 4}, 0, glaze, 1, with_alpha(kCobalt, 0.25f)}};
  std::get<Text>(items[0]).color = with_alpha(kInk, 0.5f);
  to_dark(items, 640, 480);
  ASSERT_EQ(items.size(), 3u);
  const Box& ground = std::get<Box>(items[0]);
  EXPECT_EQ(ground.rect.w, 640);
  EXPECT_EQ(ground.rect.h, 480);
  EXPECT_EQ(ground.fill.a, 1);
  EXPECT_EQ(std::get<Text>(items[1]).color.a, 0.5f);
  EXPECT_EQ(std::get<Text>(items[1]).color.r, kPlaster.r);
  const Box& box = std::get<Box>(items[2]);
  EXPECT_EQ(box.rect.x, 1);
  EXPECT_EQ(box.fill.g, glaze.g);
  EXPECT_EQ(box.border_color.a, 0.25f);
}

TEST(Dark, WordsBoxesAndLinesAllBecomePaler) {
  std::vector<Item> items{Text{}, Box{{1, 2, 3, 4}, 0, kCobalt, 1, kInk},
                          Line{{{0, 0}, {1, 1}}, {kInk, kIron}, 2}};
  std::get<Text>(items[0]).color = kFaintInk;
  to_dark(items, 640, 480);
  EXPECT_EQ(std::get<Text>(items[1]).color, in_the_dark(kFaintInk));
  EXPECT_EQ(std::get<Box>(items[2]).fill, in_the_dark(kCobalt));
  EXPECT_EQ(std::get<Box>(items[2]).border_color, in_the_dark(kInk));
  EXPECT_EQ(std::get<Line>(items[3]).colors,
            (std::vector<Color>{in_the_dark(kInk), in_the_dark(kIron)}));
}

}  // namespace
}  // namespace onggi::view::dark_test
