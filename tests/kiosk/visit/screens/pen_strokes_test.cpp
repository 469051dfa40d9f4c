#include "kiosk/visit/screens/pen_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/contact/tool.h"

namespace onggi::screens::pen_strokes_test {
namespace {

TEST(PenStrokes, AreLinesFromPointToPointAndArcsOfEllipses) {
  const auto strokes = pen_strokes("9,22 9,8; arc 12,8 3,4 180 360");
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0], (PenStroke{{9, 22}, {9, 8}}));
  ASSERT_EQ(strokes[1].size(), 21u);
  EXPECT_NEAR(strokes[1].front().first, 9, 1e-4);
  EXPECT_NEAR(strokes[1].front().second, 8, 1e-4);
  EXPECT_NEAR(strokes[1][10].first, 12, 1e-4);
  EXPECT_NEAR(strokes[1][10].second, 4, 1e-4) << "up, where y points down";
  EXPECT_NEAR(strokes[1].back().first, 15, 1e-4);
}

TEST(PenStrokes, ThatCannotBeReadAreLeftOut) {
  for (const char* wrong :
       {"", ";", "9", "9,8", "9,8 7", "9,8 a,7", "arc 1,2 3,4 5", "arcs 1,2 3,4"})
    EXPECT_TRUE(pen_strokes(wrong).empty()) << wrong;
  EXPECT_EQ(pen_strokes("9,8 7; 1,2 3,4").size(), 1u);
}

// Each ';' parts two strokes, so that none of a tool's is lost.
TEST(PenStrokes, OfEveryToolOfTheTrayLieInItsSquare) {
  for (const ToolShape& tool : tool_shapes()) {
    const auto strokes = pen_strokes(tool.drawing);
    if (tool.name == "sphere") continue;  // it lies in no tray
    const auto written = std::count(tool.drawing.begin(), tool.drawing.end(), ';') + 1;
    EXPECT_EQ(static_cast<std::ptrdiff_t>(strokes.size()), written) << tool.name;
    for (const PenStroke& stroke : strokes)
      for (const auto& [x, y] : stroke) {
        EXPECT_TRUE(x >= 0 && x <= 24 && y >= 0 && y <= 24) << tool.name << " " << x << "," << y;
      }
  }
}

}  // namespace
}  // namespace onggi::screens::pen_strokes_test
