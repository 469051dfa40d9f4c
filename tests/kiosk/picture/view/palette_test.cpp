#include "kiosk/picture/view/palette.h"

#include <gtest/gtest.h>

namespace onggi::view::palette_test {
namespace {

TEST(Palette, ContrastOfBlackOnWhiteIsTwentyOne) {
  EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xFFFFFF)), 21.0, 1e-6);
  EXPECT_NEAR(contrast(kInk, kInk), 1.0, 1e-9);
}

TEST(Palette, WordsCanBeReadOnPlaster) {
  for (const Color c : {kInk, kFaintInk, kCobalt, kIron}) EXPECT_GE(contrast(c, kPlaster), 4.5);
}

TEST(Palette, WordsCanBeReadOnCobalt) { EXPECT_GE(contrast(kPlaster, kCobalt), 4.5); }

TEST(Palette, GuideLinesStandOutFromPlaster) {
  for (const Color c : {kIron, kDeepCeladon, kFaintInk}) EXPECT_GE(contrast(c, kPlaster), 3.0);
}

}  // namespace
}  // namespace onggi::view::palette_test
