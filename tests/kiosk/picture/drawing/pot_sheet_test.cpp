#include "kiosk/picture/drawing/pot_sheet.h"

#include <gtest/gtest.h>

namespace onggi::drawing::pot_sheet_test {
namespace {

ScaledPicture even(int width, int height, std::array<int, 3> color, double pixels) {
  ScaledPicture out{{width, height, {}}, pixels};
  for (int n = 0; n < width * height; ++n) {
    for (const int part : color) out.image.rgba.push_back(static_cast<std::uint8_t>(part));
    out.image.rgba.push_back(255);
  }
  return out;
}

/// A jar of 180 mm: red view, green strip, blue zones.
PotSheet jar() {
  PotSheet sheet;
  sheet.title = "My pot, inspired by: Jar";
  sheet.subtitle = "quiet blue heron";
  sheet.facts = {"Decorated: cut", "Celadon, 180 mm high"};
  for (int n = 0; n <= 18; ++n) sheet.pot.points.push_back({0.01 * n, 0.06, n < 1 ? 0.0 : 0.054});
  sheet.side = even(240, 360, {220, 0, 0}, 2000);
  sheet.strip = even(754, 360, {0, 160, 0}, 2000);
  sheet.zones = even(754, 380, {0, 0, 220}, 2000);
  sheet.side_words = "Section and view";
  sheet.strip_words = "Unrolled";
  sheet.zones_words = "By zones";
  sheet.hands = {"Thrown by", "Decorated by"};
  return sheet;
}

struct Found {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1, count = 0;
};
Found find(const view::Image& page, int red, int green, int blue) {
  Found found;
  for (int y = 0; y < page.height; ++y)
    for (int x = 0; x < page.width; ++x) {
      const auto n = 4u * (static_cast<std::size_t>(y) * static_cast<std::size_t>(page.width) +
                           static_cast<std::size_t>(x));
      if (std::abs(page.rgba[n] - red) > 6 || std::abs(page.rgba[n + 1] - green) > 6 ||
          std::abs(page.rgba[n + 2] - blue) > 6)
        continue;
      found.left = std::min(found.left, x), found.right = std::max(found.right, x);
      found.top = std::min(found.top, y), found.bottom = std::max(found.bottom, y);
      ++found.count;
    }
  return found;
}

TEST(PotSheet, StripAndZonesHaveOneScaleAndLieApartOnThePaper) {
  const view::Image page = draw_sheet(jar());
  EXPECT_EQ(page.width, kSheetWidth);
  EXPECT_EQ(page.height, kSheetHeight);
  const Found strip = find(page, 0, 160, 0), zones = find(page, 0, 0, 220);
  ASSERT_GT(strip.count, 1000);
  ASSERT_GT(zones.count, 1000);
  EXPECT_NEAR(strip.right - strip.left, zones.right - zones.left, 3);
  EXPECT_NEAR((strip.bottom - strip.top) / 360.0, (zones.bottom - zones.top) / 380.0, 0.01);
  EXPECT_GT(zones.top, strip.bottom + 60) << "the strip's words lie between";
  EXPECT_LT(zones.bottom, kSheetHeight - 90);
  EXPECT_LE(strip.right, kSheetWidth - 88);
}

TEST(PotSheet, TheViewIsTheRightHalfAndTheSectionTheLeft) {
  const view::Image page = draw_sheet(jar());
  const Found view = find(page, 220, 0, 0);
  ASSERT_GT(view.count, 1000);
  // The jar is 120 mm by 180: half of it is as wide as a third of its height.
  EXPECT_NEAR(1.0 * (view.right - view.left) / (view.bottom - view.top), 60.0 / 180.0, 0.02);
  const Found strip = find(page, 0, 160, 0);
  EXPECT_LT(view.right, strip.left);
  // The wall is a dark bar a twentieth of the width, left of the axis.
  const int y = (view.top + view.bottom) / 2;
  int dark = 0;
  for (int x = 0; x < view.left - 4; ++x)
    dark +=
        page.rgba[4u * (static_cast<std::size_t>(y) * kSheetWidth + static_cast<std::size_t>(x))] <
        60;
  EXPECT_NEAR(dark, (view.right - view.left) * 6.0 / 60.0, 4.0);
}

TEST(PotSheet, TwoPeopleHaveALineEachToWriteTheirNamesOn) {
  PotSheet sheet = jar();
  const auto lines_of = [](const view::Image& page) {
    // Dark all the way over the last 300 pixels before the edge of the words.
    int lines = 0, last = -10;
    for (int y = kSheetHeight - 300; y < kSheetHeight - 40; ++y) {
      bool dark = true;
      for (int x = kSheetWidth - 400; x < kSheetWidth - 100 && dark; ++x)
        dark = page.rgba[4u * (static_cast<std::size_t>(y) * kSheetWidth +
                               static_cast<std::size_t>(x))] < 190;
      if (dark && y > last + 3) ++lines;
      if (dark) last = y;
    }
    return lines;
  };
  EXPECT_EQ(lines_of(draw_sheet(sheet)), 2);
  sheet.hands.clear();
  EXPECT_EQ(lines_of(draw_sheet(sheet)), 0);
}

TEST(PotSheet, ForRightToLeftReadersTheDrawingsChangeSides) {
  PotSheet sheet = jar();
  sheet.right_to_left = true;
  const view::Image page = draw_sheet(sheet);
  EXPECT_GT(find(page, 220, 0, 0).left, find(page, 0, 160, 0).right);
}

TEST(PotSheet, ABowlsWideZonesStillFit) {
  PotSheet sheet = jar();
  sheet.strip = even(2000, 200, {0, 160, 0}, 2000);
  sheet.zones = even(800, 800, {0, 0, 220}, 2000);
  const view::Image page = draw_sheet(sheet);
  const Found strip = find(page, 0, 160, 0), zones = find(page, 0, 0, 220);
  for (const Found& found : {strip, zones}) {
    EXPECT_GT(found.count, 1000);
    EXPECT_GT(found.left, 600);
    EXPECT_LT(found.right, kSheetWidth - 80);
    EXPECT_LT(found.bottom, kSheetHeight - 90);
  }
}

}  // namespace
}  // namespace onggi::drawing::pot_sheet_test
