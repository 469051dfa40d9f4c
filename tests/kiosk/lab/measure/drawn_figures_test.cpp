#include "kiosk/lab/measure/drawn_figures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::measure::drawn_figures_test {
namespace {

view::Image filled(int w, int h, std::uint8_t grey) {
  view::Image image{w, h, {}};
  image.rgba.assign(static_cast<std::size_t>(4 * w * h), grey);
  return image;
}

TEST(DrawnFigures, ContrastIsWhatThePublishedFormulaHas) {
  const std::uint8_t black[4]{0, 0, 0, 255}, white[4]{255, 255, 255, 255},
      grey[4]{0x76, 0x76, 0x76, 255};
  EXPECT_NEAR(contrast(black, white), 21, 1e-9);
  EXPECT_NEAR(contrast(white, black), 21, 1e-9);
  EXPECT_NEAR(contrast(grey, white), 4.54, 0.005) << "#767676 is known to just pass";
  EXPECT_EQ(contrast(grey, grey), 1);
}

TEST(DrawnFigures, WordsAreMeasuredByTheirFullestPixelsAgainstWhatIsBehindThem) {
  const auto behind = filled(40, 20, 255);
  auto drawn = behind;
  const auto set = [&](int x, int y, std::uint8_t grey) {
    for (int c = 0; c < 3; ++c) drawn.rgba[static_cast<std::size_t>(4 * (y * 40 + x) + c)] = grey;
  };
  for (int y = 5; y < 15; ++y) {
    set(10, y, 190), set(13, y, 190);  // edges
    set(11, y, 0x76), set(12, y, 0x76);
  }
  EXPECT_NEAR(drawn_contrast(drawn, behind, {5, 2, 20, 16}), 4.54, 0.01);
  EXPECT_EQ(drawn_contrast(drawn, behind, {20, 2, 15, 16}), 0) << "nothing is drawn there";
}

int flashes(double hz, double deep, double seconds = 3) {
  FlashCount count(20);
  for (double now = 0; now < seconds; now += 1.0 / 60) {
    const bool on = std::fmod(now * hz, 1.0) < 0.5;
    const double light = on ? 0.3 + deep : 0.3;
    const double srgb = 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    count.see(filled(40, 40, static_cast<std::uint8_t>(std::lround(255 * srgb))), now);
  }
  return count.most_in_a_second();
}

TEST(DrawnFigures, FlashesAreCountedWhereTheyAreDeepAndOften) {
  EXPECT_NEAR(flashes(5, 0.3), 5, 1);
  EXPECT_NEAR(flashes(2, 0.3), 2, 1);
  EXPECT_EQ(flashes(5, 0.05), 0) << "less than a tenth";
  EXPECT_EQ(flashes(0.2, 0.3), 0) << "one change a second is no flash";
  FlashCount slow(20);
  for (int n = 0; n < 240; ++n)  // up and down again in four seconds, little by little
    slow.see(filled(40, 40, static_cast<std::uint8_t>(n < 120 ? n : 240 - n)), n / 60.0);
  EXPECT_LE(slow.most_in_a_second(), 1);
}

}  // namespace
}  // namespace onggi::measure::drawn_figures_test
