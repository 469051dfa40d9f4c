#include "kiosk/picture/view/square_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kiosk/picture/view/palette.h"

namespace onggi::view::square_code_test {
namespace {

const std::string kPage = "https://www.museum.go.kr/relic/305";

std::vector<Rect> drawn(const SquareCode& code, float x, float y, float wanted) {
  std::vector<Item> items;
  code.draw(items, x, y, wanted);
  std::vector<Rect> found;
  for (const Item& item : items) {
    EXPECT_EQ(std::get<Box>(item).fill, kInk);
    found.push_back(std::get<Box>(item).rect);
  }
  return found;
}

TEST(SquareCode, HasTheThreeFindersOfEveryQrCode) {
  const SquareCode code(kPage);
  ASSERT_GE(code.side(), 21);
  EXPECT_EQ((code.side() - 17) % 4, 0);  // ISO/IEC 18004: 21, 25, 29 ...
  const int far = code.side() - 7;
  for (const auto& [left, top] : {std::pair{0, 0}, {far, 0}, {0, far}})
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 7; ++x) {
        const int ring = std::max(std::abs(x - 3), std::abs(y - 3));
        EXPECT_EQ(code.dark(left + x, top + y), ring != 2) << left << " " << top;
      }
}

TEST(SquareCode, IsDrawnInWholePixelsModuleByModuleWithFourOfPlasterRound) {
  const SquareCode code(kPage);
  for (const float wanted : {60.0f, 150.0f, 209.5f}) {
    const float px = static_cast<float>(code.module(wanted)), x = 33.4f, y = 70.6f;
    EXPECT_GE(px, 2.0f);
    EXPECT_EQ(code.width(wanted), px * static_cast<float>(code.side() + 8));
    if (px > 2) {
      EXPECT_LE(code.width(wanted), wanted);
    }
    int dark = 0, modules = 0;
    for (const Rect& r : drawn(code, x, y, wanted)) {
      EXPECT_EQ(r.x, std::round(r.x));
      EXPECT_EQ(r.y, std::round(r.y));
      EXPECT_EQ(r.h, px);
      EXPECT_GE(r.x, std::round(x) + 4 * px);
      EXPECT_GE(r.y, std::round(y) + 4 * px);
      EXPECT_LE(r.x + r.w, std::round(x) + code.width(wanted) - 4 * px);
      EXPECT_LE(r.y + r.h, std::round(y) + code.width(wanted) - 4 * px);
      dark += static_cast<int>(std::lround(r.w / px));
    }
    for (int row = 0; row < code.side(); ++row)
      for (int column = 0; column < code.side(); ++column)
        modules += code.dark(column, row) ? 1 : 0;
    EXPECT_EQ(dark, modules);
  }
}

TEST(SquareCode, OfNothingAndOfTooMuchIsNoneAndTakesNoRoom) {
  for (const std::string& words : {std::string(), std::string(4000, 'a')}) {
    const SquareCode code(words);
    EXPECT_TRUE(code.empty());
    EXPECT_EQ(code.width(200), 0);
    EXPECT_TRUE(drawn(code, 0, 0, 200).empty());
  }
}

TEST(SquareCode, StandsOutFromPlasterAsWordsDo) { EXPECT_GT(contrast(kInk, kPlaster), 10); }

}  // namespace
}  // namespace onggi::view::square_code_test
