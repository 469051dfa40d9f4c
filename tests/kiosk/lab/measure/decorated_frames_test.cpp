#include "kiosk/lab/measure/decorated_frames.h"

#include <gtest/gtest.h>

#include <set>

#include "kiosk/ground/files/virtual_display.h"

namespace onggi::measure::decorated_frames_test {
namespace {

TEST(ADecoratedFrame, IsTimedBesideAPlainOneInEachWayAndStateAndUnderAMovingLight) {
  auto display = files::VirtualDisplay::ensure(320, 240);
  if (!display) GTEST_SKIP() << "no display, and Xvfb is not installed";
  const auto rows = measure_decorated("config/exhibit.toml", {320, 240}, 2);
  ASSERT_TRUE(rows) << to_text(rows.error());
  std::set<std::string> seen;
  for (const DecoratedFrames& row : *rows) {
    seen.insert(row.way + ", " + row.state);
    EXPECT_GT(row.plain_ms, 0.0) << row.way;
    EXPECT_GT(row.decorated_ms, 0.0) << row.way;
    EXPECT_EQ(row.pairs, 2) << row.way;
  }
  std::set<std::string> all{"light, fired"};
  for (const std::string way : {"celadon", "onggi", "slip_painted"})
    for (const std::string state : {"dry", "wet slip", "firing", "fired"})
      all.insert(way + ", " + state);
  EXPECT_EQ(seen, all);
}

TEST(ADecoratedFrame, IsToldByItsShareOverThePlainOne) {
  const std::string text = text_of({{1280, 720, "onggi", "dry", 60, 20.0, 23.0}});
  EXPECT_NE(text.find("1280x720"), std::string::npos) << text;
  EXPECT_NE(text.find("+15%"), std::string::npos) << text;
  EXPECT_EQ(text_of(std::vector<DecoratedFrames>{}), "");
}

}  // namespace
}  // namespace onggi::measure::decorated_frames_test
